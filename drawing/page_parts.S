/* Copyright the limpet authors. GPL-3.0-or-later. The files of the page, byte by byte. */
        .section .rodata
        .global limpet_page_html, limpet_page_html_end
        .global limpet_page_style, limpet_page_style_end
        .global limpet_page_program, limpet_page_program_end
limpet_page_html:
        .incbin "page.html"
limpet_page_html_end:
limpet_page_style:
        .incbin "style.css"
limpet_page_style_end:
limpet_page_program:
        .incbin "program.js"
limpet_page_program_end:
        .section .note.GNU-stack, "", @progbits
