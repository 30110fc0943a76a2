namespace Alate.Catalogue
{
    /// <summary>Trim table of the snailfish, made by the command line: trim snailfish --bake.</summary>
    internal static class SnailfishTrims
    {
        public const string Text =
            "AQAAAGsOOg8EA83MzD2amRk+zcxMPgAAgD6PwvW8AAAAAI/C9TwBS/RcPk4+DkDocUQ/YgSYvs7qBr9ifQ29hCBuPDoNdLqtE/k6ggM7OjgubLq/F4q49jwc" +
            "OQzXLzg7biA4I4yNtya4ODdmmIO8WiDEOpan7bpZNYq7M14bOnDKFLqlxrg467mJtoEMaTiYfpg3t2Fat6WVozejgcw7BwiPvFnV1jrS/Le5v0QyOqQanDl/" +
            "s/w3JNI9OBLVWrd6DbU3ofHLtiIYHLXvh3u+67qzvZ+xKryXw0C9BvFRPEzF+Ly7jSQ7RKMVu8o+0Dq8hwk6CCjPuELNTLc5Ela/NdCCP5oOKD10bcu61Li4" +
            "v2depD93nR87yjtJO7YyE7uaquA6y0PrvodsbkAYwma+HO89vs6M37/xLA9A379rOoXPFrwOmF09pQbzPI5mO0CtiodBCTFcv0dqi78HAHY/lNhHQGzdhTn9" +
            "QYW9wmGyPpmbNz5zIbDAzR9qweBAzD8h8J0/c0dlwFMz7D1fanQ8R3W5PZxtyr7KSEG+bDlGwV5ugMAXnCE/+RL4v6t6lT5CAmO/TYC8PkscQT+NNVvAJHU4" +
            "Pmp7GsCA/sC+mclOPcX6JsC9eKs8mbwgPgHTcwA/mvwLQNuoPD9zjJO+LMQGv81lEb1Kt1w8dNu0uiNDGzog60k6ejZtutYRPbhLkfw4kvQ1OHEuBziA0ZO3" +
            "q69JN2Q+obsYSyS7PQi0ujUZirv50qM5dFWHuWt5qziaYiy4AfQLOEY9MDYADO+2IWUuN3zizzuxZIK8NvDNOlelybllGyY6QoJ3OQdbYDgFK6Y3n1RQN/QN" +
            "FDcBjpE3QEAuthIFYL6d8rK9rFMevB9+Mr3+xTg8ySTavPlaAzuJQwS7LaihOqZgBTomSfq4LL4guK8jRr/+ZGM/DBKyPUA/ET0uZoi/nHnQP/RyNzs+a7I7" +
            "HQVjvCdOerti7QE/w8drQEsJVb4TYze+LUmNvzEmKkBNHnk60Knwu5gcST2fwt08kHntQIQwc0HK3VG/FSyLv29+3D8yvTJA8nKGutcqbL3plak+i5gsPgWH" +
            "H8FzYVLBqb3ZP8jRqz+AGlzAo5xzPxUnijwovrU9zmDSvltaRr7uDUbBM5FbwGIToz/9huG/Bb1NPw+wHL9y9qw+sXIvPxlbksCMSaS/PFwOwLoHHb+TQZA+" +
            "4aQawPH9dj2jVG4+AaIXSj+TQw1AGUJBP0Wukb51OgK/frcYvfG3WTxuIuC6ic44up0kZjo8S4S6b84qt7Sc8TheEHE4h30yOGEit7fSlJI36Ry6OyXa4bur" +
            "xYa6YQWTu1oBzDg/fwo4TV/bOHJZsrgtJ7A30euett6hIbZfZw83qIvmO6t3eLwiDdA6jKmOuSD1KTophIg597UIOEK7IDhFBRO3jwKBN8+rybXWUVK2U7ZY" +
            "vqQOyb0ZEgC8xOI4vUgrOjwTE+q8e8UYOxBBDbtmB606RF8KOgT0HbncWw63baA/vokIqT9PWTs98PNXO4BD/r7B+vQ/uSAeOxHnVjuhzn+7F71QOhJM8z8B" +
            "hmtAG/qTvntCZr5j6Bq+8BY4QOeo7TlShji8dZyIPT5OEz3XVitBrfE9QXMqY796v4e/5CohQNNRAkA36pm55JJ3vR3Lrj5CNjQ+HlNEwdohE8F6kdw/C8yk" +
            "P7K5O8DycwJAAZ95PFwFtz0gItS+pnxMvkZgMMFOFijAXpnSP9Qbmr/YJYw/gVigv0ogoz7ntR8/e7SbwPrLAsBt7vC/0xYRvy1lAT/R7c2/C6KkPfAQkz4B" +
            "LrhXPiJ2GUDVMGU/gYQ4vmp8jr6LBka9u43nPEj8IDk5+zI7PbUoOiFHvroslXK5/G07OZEhibd6oFM4JvZ6uMGHgLfCtYy8c0S0ufpSEbsq/Ni7SvkxOi6X" +
            "HLmCsiw55s7ZuD/T1LYzcok4q2HTt3k6lzfEA9I8IC9KPFGkrDqdPHM6V75cOoTT+jgkHOU2elLLOO8Y4rduLYA4514/uDP0FDjoo0I+NvfFvnoV8zwEPhi9" +
            "rUSJO0hsF72ZZjs7jMDLOhfSgTpIYN06NFNDOvPc0jpOQlK/gtKsPwN9ab4rGqq9rliRv9FX3z8T0As3Sx7Ku1yXKT3cPaU8IQvDv7LeT0AuSoe/pHy0vqKM" +
            "NL+iDzBAOW+su/VfAL1CZTQ+e5inPSBhbr8yXmVAzowvv7s9t76Csn8/VHU2QB0K5LqbLRC95HVNPvznvT2YfAtAp9O4wIOCSkDq7JM/WPlewH+jNT9ohcY8" +
            "+ofxPd/4Gr8zfYu+5MnDwI4cecAZY8E+lvyuv4WWWz7irsu/gqmzPmsXOD8sSj7AMwOTPkgzA8B2aFK+DFvsPBxnD8AghZy7hlgPPgEaW8I+MIEUQNvlXj/s" +
            "7hS+gnKJvu9QQr0Fr9o8sMTkufTanDqMaC862PWkuoinGbnU/vY4+8oet5QigzgOK1m4G3YoNudM2LvQmam7UbsBu1vP17vKI/I5Y668OKJxPjly0AW5kt7t" +
            "NtHDMzg8xAi3ih2BN8mi4jwYjIM8LOuFOsAGkToiNSw6K5mbOJsYMLiW8fE3fx2Jt1nYO7eq5BC2pldct3P0bz63OdC+u/UEPYPzAr0NaHI7CmgDvWKpSTt5" +
            "xrc6oDB/Ov/8cToNbzc639aEOtx4Hr9Nf7s/Pnhhvo8Qnr2+iU2/EuIAQC2DfzmrRra7uUwRPd2DjTyOroi/DXJDQEI8eb+TRaG+2PNXvjxNN0Ag85i7qxPl" +
            "vLfWFT5f3ok9BWvSvmcTT0C+YyW/KEervnTHxj8AqydAg741u2FKCr2AWDU+TH2jPWPMBEC7XKfAKdRWQP/Cmj/BnFDADhadP2aF5zwCFgE+eoQYvwKShr6R" +
            "BsbAt493wFf8Wz9fCrC/1Lr2Pk5axb9HGr8+CzkzP50kWsBg/Cy/d7fyv/cvrL5UL+o99+8BwDNaAD0J00E+AQzCCT9+MRJAtHZcP8NtyL3Wb3G+gVA6vfQ1" +
            "0DxGJkC6+yiguI8KJDoHZY+6AET9uOq4VzjRTbS3IQlOONuVZbj8PDq2ZidIO1GgI7wPm+O6E33UuxWTkzk/7rk51aFNOdw9B7mdaws3J4oCOGQk6TbO10U3" +
            "Gd4FPScLuDxhAnU6MICcOoT5JjqzQYc4PkoluBlOrDipTfC3ERkiOBytALgRqHI3SuCmPof08L7xVhA9lIDQvHYHyDrQBOG8Y59EOycZMTt7B7s6/U5tOuwm" +
            "rjrVJUw6NXDbvmkBwz9qeHe+RBeWvTvrqb4LIg5AMnEuObNRbrsazAs94t6GPL+ci7+8Lj1ARpSSv/4ir75JAAA/pO00QCGF1LssHMu8eo8pPhF/mD1eq92+" +
            "I2wmQJ3ATb8rirS+o+YLQN49B0C0FNK7MIEBvX2JRT7w+q097GFWQDlFY8CwnmRAywOYPy0NMsCSZv4/s7IMPXrD2T07Nxy/mxWHvvfwxMBb5m3Aj4ClPyvR" +
            "qb8GHjw/DIzrvxHHsz7IRy8/S79ewKTLqr80N9O/zZDNvmCkWj54lLe/t/wsPaIcXT4BEtZ+PUUSHkARhng/3ABnPaD+gr3/nTq9q+oCPULkbTnSUC87DqI2" +
            "ucUM0Lr42um5gwyiN34TaLiLW0Q5rfGLuFT3QDhZG0W8nc/7uT0HobrcAPS7rPRxOVEVtDnzoG45xdJaubI0drb0zYg4qk+wt0oe+rZ5EWI9XxJuPXyxHLgO" +
            "pN06SNUdOvunwzljwCy5UX8lOTSk5jf+P9U4V5lQNzvZQThYz2g/EoFcv5dCXj16ujw7FU2QPB4957xVGxQ8VnZKPK3l6DubFFO7a9B6O5jzgrujXdi/Bg6J" +
            "P444K78rPPC9Z3Q8v+duEUAMR5M6QCAJOgyksj0l2/g8cWd4wNQkrj+9x/O/yAWrvl6kI76xYFFAjyoJuvY1NruXMoE+BFSvPdqax8CywJa/VBdXwKWULL/T" +
            "GCpAQQ99P1P0GbxLDsa8ZgkNP8QANz60WcdAVH8lQGfDTkBiBSQ/f8u7v/Pb/z961kI8qonVPAP4Bb+d/Su+1l2wwEOEgMB6dwq/UAK/v3Xc3TyaLQbAmZCt" +
            "PtAmFD/QpjzAAnw/PwKqA8Bb8sS9kjrAu/82wb9Ugwe98+2bPQEk4VE+sPAcQPQbdj/lgYE9a1x8vS9RPL2+zf889HaDt+Bhxzp13/W4U2vBuqrJ07mbjH24" +
            "zSdluPutHTkFfKS4WTnNNxdspLtVXKK7xYGmus9T+bv+zm45tCcQOvGuijkjlki5ahJyNqp5Jji9HAq3cFuQNgeGZD17xW497tqwuI4p2jr5/Qs6x+urOYoR" +
            "Q7lViQY5NRS6Nyh2iDh0Zsc3QGn7N6h7Zz+plF2/mqJXPTx+KTtw/4M8bsnYvOiaEjwMOlA8lMvNOyMZE7vUloU7yiBEu+MNyL+czKU/HEcvv8569722DMO+" +
            "E04XQADi3DnrXTa5TE2yPZ8d/TxY92TAdhbwPy54678+66W+dpuTPmePU0AHNwu7vC6Eu6hwcj7Glac9LpLPwAvKCL+Wm1bAwsUuv72OMkDNJhI//cZxvDQv" +
            "7LzyOwo/w/w3Po7U1kDj8e4/PhVPQEWMJj/PjJK/EicHQMQcijxPgvc80bkDv2AvLb4leMDAFCNzwEH7ij2UlLu/J0KmPqsKCsDJHq4+PCYiP0R4NsAk4KY9" +
            "RIwAwHqrS75whPU81dKBv8u7vbuVCOc9AZ7xqz5KuBxACTR2P0ymsT1Hj+G8sV44vXSO9zxOvC25E4O3Od4TLrkC0a66u+K+uWMNzrg66S645Vo6ObPIULgU" +
            "WVQ4DVYCO4bmF7xYZJu61tH6u8ZKZTkYjEo6HYWuOZfSPrl81Fg3q11aNuPW1bazX8i2DJx1PWQQgz14fdi4u03ROkRqBDqG58o5mNxIuafcHjmEWAk4ynaV" +
            "OC3KzDeS1u03CLt9PxjSbb+O5k09WChNO04fmjzjZc283tEoPBtLVDwVdtY7QZpjuxB7aDvPzmm7H93Ev7CszD8rbT2//RIBvhK9qTwWYR5Aa57IOZB6RzoL" +
            "JMc9NHMAPaktaMCAeR9AJYb0vzVTpr5vUlA/9AlUQOBl+LrvTdC67TSCPqgKoz2ZoOfA88RtPtaGXMCxGi2/01kzQNHRjr5BS4e8AQnIvAtJEz/JrC4+blfM" +
            "QI7vST8YqjBA2HIJPw/GE78YRQFASql0PCrgsTxl/+m+SXgJvlijGkBmlA7B6zRZv9M71L+Abjk+5NLWP5pZvT5wwIQ9yao0v5Wp6b9SHA/AXqbGvt6m97sz" +
            "S7c+DzeLPJx8lj0Br3YBPVg8KkBXJ5A/ubHxPQyt4T21FEu91eQSPaXJzzmp6V47kKaJulT84Lr3AQK6k74FuR1IfjjBv6k5BywHtyhYNTlQQje8Z6kJu+Ym" +
            "Iro4EBW8fvt+ub80dDr1fs85ts8EukX3BDiPNI44MN2Bt3ox7jdBP5E9XKfPPTp2Ujo/WQM7i1eBOkaptjqNGNC563fZOWSH4jgNy6A4TMAoOM9fw7d+CNs/" +
            "+IWYv4nJij0qaMG8tdKRPTWGVr2c1+k8w5TiPEZoDjxyH4a8FzChOldsCbx2fbS/s/OyP3QPAL81tWK9mTtIvyPHH0CeSZM7hMrvO6VkZz1WbGE8692HwDpf" +
            "3D/wG/6/wrxsvjo9M76LwmNA+DbrO1v3YTwx8YI+qfJcPUZzBMHLYRTAFrmCwMHcDL9wASVAWTAevijoaTtmgY85A9srP7cm/T0DzIVAqe/fP8Pi6T8/NIM+" +
            "lDMlvsvwgD9BLia60g5LO1+ko76YSmm98YwwQGkxZsFZEK7Ak6ezv142pb4wqN4+MAK3PsThEb+pnW9Af7fwwCQR6MCCJne+8/26vljU3z+ZXIa9vAN3vwEp" +
            "qxo+tCMqQHj4jj+UNv49itz9PcnVS71g8hA9KW3fOVgeDjv9To+6eb3Mut5++7lE9Uq52cpyOFTmqTnu1oM3jTApOQP1obui5827oEk0uhQtF7y+Oc243/uT" +
            "Oss87Tl4/fW5LBniN7tlpjevopi3TtCuNri0lD2JLNE9ryQ7Ogf17jpKrYA6PBqzOrjLqLnU+eY5s3UXOWBw+Tjz5ug3/CPPN5h73D/LSJy/zRGCPfyasLyE" +
            "HZQ9QvNNvRSu+Tz+KNY82vELPJ+Iiry4QHc6pRgPvKRVpr/PYL8/L38Hv/BMbr0C0e2+484gQJJAnTu4G9Y7J6GAPXBPazy22n3AphsPQMta/r/S2GW+UVKT" +
            "PvQhZ0D1vhI8ImFGPGVtgT6kdlg9GroNwdLeub8PX4nAi5UPvzN1IEDdAwK/+k4LPNemTru4FjE/dREDPjrTjUBhEZ4/YLHyP88Ngz4lrgm9x2l7P4eBRrtg" +
            "Foo7D5qkvi/mbb1LvalA8UxYwT8Mo79ZW5S/0087vs9Ojz4Yjd8+byTsvZSVCEHcfhbB+POswAQLCb3Nlga/eO/oP0vTFD0J9X2/AZJmiD7IjypA5C+PPxd5" +
            "Az5W2gA+ABtNvZSTDD3wgoQ533KaOgUvkbr92bC6qL/6ucLXjblTFak39SmWOZLfAbhUpRE5f1CTOoYPKrxhXCa6amkbvKG5gDfCV6w6jAUCOtPt4LnMz8s3" +
            "Aj3Kt70jkbVOyYk2h4KUPd4c1D1E9006jprqOhp1hDpyh6c6Xla3uVjWyTljGw85CNO0OAvqXjgmuxE3Xe3fPzSdnL+drH091LDVvBFKjD05n129hEPpPICv" +
            "3DwcAQc8K3eBvPgizjryBx+839OBv6LT0T+j8ve+53hYvZqpGb6o9SNA/KCeO1fRzTu1ol89xxJpPN9casA0Ui1A6y8AwAsoZr7wSEM/+0JjQIZNIzyW90g8" +
            "mhWAPhP/Zj0DHA7BUETNvqKhicA0AA6/2T4ZQFM2XL/U9lY8vBpMu+HoLj9ZfAo+g0WOQKGrIj/DufA/yOV/PhF2sj38RWc/r02vu63vgDthf6C+KYd4vXXr" +
            "50DtRnrBZ3SFPxWbqr8i8oK9GXkZP1b26T45qLc8x/7xQEWrGsHb7BzABn6svvaryb5QPc0/odN1PY/gA78=";
    }
}
