// Copyright the limpet authors. GPL-3.0-or-later.
int main() {}
