# What `make install` leaves behind.
install(TARGETS limpet RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
