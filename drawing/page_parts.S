/* Copyright the limpet authors. GPL-3.0-or-later. The files of the page, byte by byte. */
        .section .rodata
        .global kLimpetPageHtml, kLimpetPageHtmlEnd
        .global kLimpetPageStyle, kLimpetPageStyleEnd
        .global kLimpetPageProgram, kLimpetPageProgramEnd
kLimpetPageHtml:
        .incbin "page.html"
kLimpetPageHtmlEnd:
kLimpetPageStyle:
        .incbin "style.css"
kLimpetPageStyleEnd:
kLimpetPageProgram:
        .incbin "program.js"
kLimpetPageProgramEnd:
        .section .note.GNU-stack, "", @progbits
