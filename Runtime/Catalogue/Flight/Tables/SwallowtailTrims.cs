namespace Alate.Catalogue
{
    /// <summary>Trim table of the swallowtail, made by the command line: trim swallowtail --bake.</summary>
    internal static class SwallowtailTrims
    {
        public const string Text =
            "AQAAAL6Z74gGBAAAAACamRk+mpmZPmZmJj8AAIA/ZmamP5qZmb6amRm+AAAAAJqZmT4AAAHftlY/MjxaQYHaaj97ExA+hpvWvoz3ir4EGvq610zBPGRmhb20MYM8gOuouv0qqbieX3A7xAChOUmwqb" +
            "kBaJk5HR9FOv/lpD4qrM67XVwEvd9cEDx5SUS8BySgOqdTGbpK6067l+D2ufEr/rj7zpQ4pNmutxd+ub3uRa+9e+8muf4K8Tug9jk84w53uo0O1LiEZ3I6dfTtuV7c3DjaOpS3jxdntxda7MCxI/pA" +
            "Y86lP2ez1TwiNYO+IBlHwB/6tT76uyU94qFdPUoobz5z4tq7m+hJPMtbRD9vQuQ/NL8QQBs8Qj2uWAJATXf+Pvz4Lj2srzU+hgt2vjOhI77UyLU/u711vw+ExL+jGEm9xIZBQHtvvL+GYMs8lo31vb" +
            "u+RT418p0+fzVgvqZQoMDk5rTA/DcHvj8MOr/AaTrAdxcVvcB/yr5WDx8/B+EaP+8yGT9x+FnA2GqewEQaAL7RC4i/LEzBP/htsbygFMS+WMUQP3z/Gz+7Cdi/x+RwP8/mKkAFhQi9KBN6PQMOzr+E" +
            "+qM+U5LIPgRIeL8fHW/A/Vp5vwTljr06y+E8y+ohP0GUIb4FVbE+Aby+bT/Y7GRB6BKBPyUrGj4FzAO/kztpvtqmDTwnF7M8P76LveTzejyVMTu7Fcw6utodYTtESBg4bTGAudOH9DmCG0c6YjupPt" +
            "aavbxWwgW91TagPDM0Vrzt4T07do9Eupv3oruZgfo3XpO0ufz5hDi8Q4y4M20BvmGk3L2rL6076W8fPHSbXjzeppi6a1Qyubj5nTqVXhK6HjrmOCaCorZX7YK3IBQcwcAtN0HWG+c/npV7v3mtq77E" +
            "sHvAeTr+PpR/hz2Hd3w9eoqePme/Cbw1tJE59rArPwxl5D/bUAFATkAoPWGIAEA0WwI/liMjPXp0Kz6Dv16+UcvqvZwavT+sN4u+umjmvtqOtrxQbktAjc7Tv63mjDyoJlC9zWB4PdGIIj7TTBU+Si" +
            "+UwHKOjsDHsM69VSZVv8OgO8CMXDG9EyOgvtsj7z5gp9M+Vu+TP5jhc8DpxojATKvbvU98zr7tGz0/S3jovHVsqL4MwO0+AZf4PthbEsC8LYA/RLstQPS+5ryJSoE9gKHZv2vjpD7qgbs+KDOav44K" +
            "acDsdX6/fS9ovQI8wTzIG5E+Ua9Lvptftz4BW5zpPtMnPkHZ3BY/BxYCvYmDNj7FNqK+iWIcvfk2gzwLLBi9PYYRPBftijuk/Qq6sXSfuBzzYDhT4Ho5Cr6kuHBjiDgP6L09zCCYPKAFKryyPXu8uE" +
            "mzun47mbpoKxs5wMjvOTyvkThzYXu5Nvu2uP5zkzhqO7U9bLx8PZqVcburpI87VHRDujvkjbrLXuo4MfvvOe4QKbhk7VG5r7nBt4+rQTiPNJRAVpPUwP0PKz+U+g8/j7uCvmKdMz5MShg+tKwVve3V" +
            "sr0fh408H/zJPDDdTjxJMic/JTN1P5hJoD/K6Z08ugByQKTTGr5DB1Q8buFnPcwQFb6THZu9xVnDPgzY+T+/uBZAG8gUPZUNsb8gjWdA+nRIPPvlqD1ln46+H6cavnLWn7ofUNa+VrNLP9iTeTwDl5" +
            "a+KznsvlfzQ7wM9nE8k2wYvjiJxL0LSSm/bQMCv1gIaMA/3YC9Wy3Ov+wmIr8J/zA8O7ftvXxgED9Si6s+ZhoLv7aPcD8nkeA/1b4rvK8tOzyuBwjAZV8gPuEqFj5K1QA+UOsnwLpDFb66t+i9KpfM" +
            "OrUGnj/qP6g+grn/PgGtPTo/kos/QXSLRj9JjT8+/zEePsPOoL5wyTm9wgOVPE1Tcr3ep1g8mbrNO2s1G7qDz8s6iWgaufMQRzkEk0K4TKehOO/usD6Nni897SPkvMagcLyLOTy8cd5Iu/oHEzvoVP" +
            "y50Yc7uVdPGbrpawG3J/MROSSPsj0exp49CbsTvLPzJzvwEIA6HruXuqeBDTq1jC849dxduZOhQ7l/1U44g/KnOJSnu0DI69LA2+7JPgevsT9jDY2+kqZqvr6+Nzw0qTS+3xGsvSjEuj3bDDA9OA75" +
            "vLLoaj+WfS8/nZIqP3p+EzxeHTxAkhK+v0bb/DzO/lE9NXAWvXXaM7yppZk/cqC+P2yYAz+VtG47PVAJQJ8fxD9a90k9OQ47PaMHzjwiPSQ9YdGtPcUccL4YQlQ+K5GEO7xTXj8oOxTAUHdKOsuGSD" +
            "xAgM28FBylvGaPg76x/b291ZdUwObkgL2epfu+Q7UVwMhOrDxyHyq+FbH6PkR+rj5p1sO+1hpcP9a2vT8a8tK8sLLDPCaXqb+WO1E+qzmhPlSvQL+MUDnAV6DYPs3TmL14HMw8gLDmPgp7HD6BDKY+" +
            "AVktUT/QwExB+ipLP0e2dD7T5MI8snmEvghSCr3JpmM83+KAvZdoWDyQ85Y7ZcDiuApqADsCdu04cP0uOYvEuriymgc5PQjMPodJJT3Fz+28+7vEu+z3f7xEwzu7lYg1O47Uwroazxa6ndcwuldRWT" +
            "n1eEA50H4vPfmFJD26af27dc5wOzE4WjuGLKK6iXreOf4Yvbi48Yq5in9/uN9XnDgmF1E43g5QQDnIXcDO/ho/tHKjP5rBor4eyVm/1C4KvRnIHL63ae+8ew8APq8NCT1vsEa9t2FdP/+DAz9P2YY+" +
            "fabKOlBE7j+F9uC+vnH5PBsmBz1C8yQ8ZjvqPPeItj+K/Yo+tE5bwHEnlr0UX+c/Eouav/S3jj2CCgu+MrIRP0yk4j72dY++xiyjv46xoMAvGca96+sLwFzGOsBgZ7c80lB0vl11Nj8i1P8+CMz7vW" +
            "pNRD7x3QK/QNcqvMD5uL+VZQZA6s9Tu4yIE71GpIc9sTBHPZqL974Go40/vjbbP9vr4bwUOCE97iqhv0uHgD7I/bI+ZxuMv7pFTsD8/h8+taSDvZBw6DwEX2o+y5QaPL5ZeT4AAAEUvw4/CAY+QT3Q" +
            "Lj/3QhA9yBEsPiiTsb7kHUi9MYWGPH0kOr18szM8ZrbGO62jRboFxOk507fcuM3bwDn1X6U36IkOt/TsND5BWtk8bmZnvDnzlbzkpZu7Ufw9u+VWkDqWjr45fJKat/Gd17lbHSy4//QnuAqLwT1C1Y" +
            "c9c2V4uz2gRTu3s0G4xEi/uhd1xDkrHtA5oclQuIVwibnsrwO3ltGkOOk8n0DB2uLADc7rPkABFD8MPK++l7Q6PFdzBT5Mtfi90VDmvQEtujxBNzQ96L7GO2EsQD8ZEnw/KC2IP3A0gDzOXGRAA5nO" +
            "vouTvDzafX49oL7TvRSvZr3BpkE/d0LeP9IEyj+dlLo8GenNPwj7EUB8M/U8i6qlPZHpFL7xKqG9+7R3Pe0znL7GAmk/2ZuJPF4EFT/tw26/ypQpvIWr9TyyWRy+FhLRvejPB77M+O69JxpGwFjxYL" +
            "0IL54/6P0nwL6BrDyEp+W9EkP6PmLmoT7n2ru+tjRoP7w98T+mapi8vtZ+PP7P579sKGk++eZqPnPaWb7HJyzAFX5rvswhs70oGRc8giJmPw9oaz6UuOI+AYoGLT+G30JBPCZDP4eFHj5lc/o9wzap" +
            "vjQGTL2E6YA8ZgJpvZfpVjxdP8s77Q4uumrDojrgLiO5x4e+OdVK2TfQ9re4D7KaPo6AHT1teKq8rh+AvBrIJry5poG7u7UdOxUQfLlZFzu5cTE1ulio/jbuQZQ4reqlPV4cfD1Zp7O7AnIeO/Xkrz" +
            "opGsG6zh4MOobiWjmrGBW5ewBcuRJaEjiNHL84862XQE2Fx8Cy9sI+MYdbPy7Ytb6wbaa+tIaWPcrlOb6Wq7295RB9PZ5jZD0So668UwdHP+NyXD9TEQo/3yLVOyRiC0DdDO29hjMAPbMnPj0Np6q8" +
            "LyERuyN6mD/G3sA/5wSGPtFZgrpPgTRAygExP47zYT0o/T09rf52PRGQfT0utIk9qGMTviRq9j6bVBM8k637Plu/yL9sn9K6DmTFPO7ji700H0i9T6DJPMyrPL4vEFDAxw93vfAf2j1+mVnA2uIHPR" +
            "O3BL4PGf0+EPOuPqcZmL7EVHo/STfvP7FpxLwupcM8Qua8v0kaiT4xfqA+k1MxvzeoN8ANhQC+qsOPvV48jTwHEgQ/f83tPYqJqj4B3o5hP1o8UkFf9FY/rjcHPj/hG76DxI6+55blvN/yZDygjYa9" +
            "ATKHPJyGMjs5uii6CDEIO8v9ijnDkrs5dS5JuTu+LTgPoMI++1e9PEWQxbwQgbW6bleOvJtlrro9qFs7l/cSuw0ycLqupU66acHIOdxvnDneyyW8g6CPvI81kLv/FEY7Fn3pOxUeSrqLpgQ6lZlCOS" +
            "CvrLlozsg4xL6AOGtATTgEu7m/PcVYPzDHAT9YST8/E4BBvlbw7r+0ZII91Q5KvtfATT2v1ic+46qOPPOGSL3ze0k/KVlrP7Aimz9Il6c83C4RQFjifz6Ek9w8l2iwPdlADr5bX5m9DLXSPzWZzL9z" +
            "HZTA0ZPRvfDR7z8xoOm/h+pyPX9Ifr4vPz8/248lP7Rngz0VMiPAdcCbwC+CyL2GJBPAogjzv2CXYTwt6Ii+KNA1PxHvCz8ok1o+Bg8oP8uS6z5Pm+c7TdvuPU0y9D/wG9Y6h++FPLY/ir0uH/G82i" +
            "huv0+Amz8SvBNA0uLYvD2wNj2A9bu/a0OiPtDZvT4lQIe/rcJAwP2VN79An0+9CxKLPHJXZD6gIrm9JayIPgABov7sPlFWPkEGDQ4/pDs2vj34Az4yqp6+OcQYvdfwADz8a/G80NTlO+1QrTv9kAK6" +
            "mfGtuQWJhre1ork5rLT/t6BZTLhRmjg9b6p5Owwb07sJuIu8+9SsumRrDruaFXM53JrUOQJaC7fz/JW5BqpzuBW3RTf/Zas9x8O6POmofTofXeY69aSdOZSZv7rAizc5UYPGOYh97TeKZzq5q1+itz" +
            "kBKjg0Rts/4DzJwMd2iT4qfxe+ZSSwvqhskb0SRv49iiRrvcM0nL2UlEm89im/POM+Mzylr6E+HbZdPzh7Kz8BdxI83dk2QE67Yz97whY8uCrbPLysnb2FZBe9v7OcPuXusT+9+Y4/o+JyPLG+JkDb" +
            "9vg/s5hPPFN5ET1M2PO95XhpvT5q2zzMCpe+f/klP1uRQDxAL0U/lnlHv5LDs7sAwTY8okQDvr4cmr0U7ZQ+XBravl9xV8DIo2K9X+XcP+wJH8D6Wlk8QX5VvWqGCz+54Jw+DE/2vpjbAT4JOTxANN" +
            "YNvUFGizwqNhbAk3WiPuiqfj61ZIc9z74NwFsun79eS6u9v1EAvKFgkT/T6hw+txvxPgFjFA0/EUU+QbGAKz8fcLG9OYHoPeDJvL6LYla9OwI+PO8vKb1P4TI8e3ncOx0berqx2S057SAMuEgM9DkD" +
            "Ajm4Bs9YuCvKBT5LNVA8zmIvvL72sLzEI3m7n4xeu8tEiTq98+85p9NDuErVDbpG3R64cdJKOLlYuj2MA/s8QqIXOU1lhzp2r4Y6fAzVurzj1zlbgPA5HE28t7/tabljKZy1Wt6rON9NE0BBtdrA0X" +
            "0hPv2otLyL7MO+k7B3vnaEGT7p0Qm+x2/FvUi9HjwvWTs9q5gjOqPNzT6Mcn0/JrFFP76eKTxRvRBATrKEP6dhjjy9SB89TOWcvaiSJr12HA0/10rGP7dyYz/T4S08Vz8pQMpH8z9m+uE8YBtBPUww" +
            "gL3R5+C80zUYPLNPOb4JaTs/uzJXPHMpSD/ufUm/IjS2u9S5vjx5eQW+l4yuvUZsxj5Uo9q98kRHwMt1W70oeOI/6tUvwIyTsTzLDKS9LWUAPzwzpT7tp9G+Cx6nPk9dL0CxcwG94OaiPHxaAsAzLJ" +
            "0+q6SOPh51ir4LDw/AbPaHvxN8h73RJJq4MMtnPzoV6T1AyNU+Adb/Lj8/3UhBNkJHPxdlND2N/4w8XI7EvhITbL0Pw1U8FPttvYjggTwHR8871q2putbrnzoPDAe4PMEVOppO5rjIgEe5N/eQPnbZ" +
            "wDxxyYy8QkuZvJ4gJrwN6oO7lMk9O98PyLlZA6S5MQKCunjq6zizCoM59Ap/PZcKRzyhFr26r4pZOtlYbjt1A7a6w98hOo/Xyzl4uxa5fxMHuSaYUjhFH8o48uR2PxUQnsBg8gk+/EltPnRCsr6JvW" +
            "i/pUMIPpRNWr4BKm69iV6OPSSxfT1bEv+87ZgXPwmxXD9Gbtw+jVqNOx8Y5D8Qums/pEDYPBdAEz3sRrm8JQ8TOtGemz9qWZ8/poQbvx/3hrwsU0VAKbcnP4+nWT1mYgk8JugoPuM3Gz7XN8A9Kg97" +
            "vFOjZT7aJ4U75/4EP/JHqr8NkpA7B4qkPL9UH73wIOa8Nn4mP9z7074BRkvAp7BqvfKrTT5No1bAXpnlPEQk8b2pZPs+suC8PtnlD782LB4/3xMuQD5cAr2mk+482dnav1cKoz7OPqg+8bA7v4fHE8" +
            "AJxYe/FiJEvQaJxTsdGPE+6kTCPAbcqj4AAf5PwD6maj5BL9gPP4J/dr7l6549Iji3vtGTGL1MigE8xEzDvNzMBjzLMKE7RMsmutaXAblYZ983GBbcOSPvDLjgGTO4hG8/O9hKD7xQifi7eBS2vPO1" +
            "hbp8jpq6jhbyOba4RTky4NK4gTSsuc86YriPCho3epi2PYmsWLxVF746rHe6uhOcljp7SmW6sLKIOYIyfDnZ4pM2eFrPuFrewjaBW8037Xd+v2J41sDdcl6+DddivublUr7yjoq+0lOhPXFqrr3oyC" +
            "69UYTjuvCGYDywb0a7ysjHPerVPT+92q0+rrhoOyAb4z9kp/4/kTf5O7EbeDwwfwa9cugUvCD5oj0K6ps/Bw0VPyc+xTtN7Ps/9H47QGP2VzyuD8E86Vo/vWi5QLzJUme8HgwKvpgDDT/ROBs84KN5" +
            "P7lopL6j5DS7GOvoO+lv1b0VQ429ZT88P8FECz7jbC/ABhI3vRXPIUCr/Pe/p+xKPAySZbxWMuE+8VyRPpEAA7/5v7O/Tnc+QHZjZ700ezM8pQsdwIpYtj59EqM+vdK5uuTTy7+ep96/kP5evSXNV7" +
            "ytqZs/sx6EPZaQ0z4BuyHiPqxCPkF1nyg/59MrvlqeZz2W5NW+cmFJvYsyODytqQ69oLdGPOojzjuYh466OA1wOWGRUzbPjSE6fip1uCSv27gdR4Y97m+yu9dlM7wOCtu8oZQhu12z8bpDVIo6VdZF" +
            "ORumG7lJAQu65BnHtymwaTi53bo9KZNFvJlhhTqlfNi6XBEMOzWUibqJY9Y5YHSxOcQ/2beyQP647g2nN6RkYjjk12e/Qk7bwM4Lgb6++R6+BPd8vrPDAL+mkuI9IbUIvtvFVr1Avzk83cn1PNYMNL" +
            "xE5SM+PS5VP+390j5zUJE7wmnVPzNu8T8OWVc8mW+2PHBhFr3oVEG8qXiNPrL0qD/Bt8I+jA0cO6F3CkAlfSlAjKq3PFGQ9DwqSxC8L6KAPMRI4LyOOKm9roQIP/0DGDwbFnU/jMnFvh9m+bqCimI8" +
            "DTvIvQV8kb0LlU4/mXjJPbLLL8AvrD29GREUQAT8D8AN5G48KoomvcP43j6uT6M+ZvgKv4AVdr+BgEFABl0/vWyAgzx4yw7AROWwPgA9oj4X55a+ywfJv6fzxb9R4z+9nocEvFUlbj9GvIA9xzrKPg" +
            "HT5g0/qYZIQSKcRT/HoFO9M1CNvKJ27r6sbHC9YixvPFJbWr0VyZU87EDQOxq64rpqCbE6gc8aNt+xXTo5lRm59S6BuaY9TD6He646d8KHvK922byTwuS7lLUfu6XNJju+Fh26GnS+uZ0fZro4IA05" +
            "hyJgOaj8hj31lrq8j4YMuAQ/fbrfKJc7uSuFunQ8EjqnPsg5LD8cuX9NgbjZMV048s6iOJLc5r8REqfAUbIgvjomoTty0IG+A+iSv5ovCj79c0a+SLDvvPNehz3E5zM92Fz1vEbYsj50IFQ/ToidPo" +
            "KMGDt0g8k/rfTHP2hwsDztsug8s+CUvNAKCDy6XVU/m22cP6yhv77stze8E/gtQPCl6j/dFCI9hmmZPPQj1z1nDAA+AeakPOLRDD3mJ6E+wHq0O4y2YD+l2TO/aSHeOsnlnTyyYHe9qPE8vWRfgz/K" +
            "6Wm+haQywDiAR703FK4/PChCwJntujzmQ5+9nUHdPpAcvD77eUW/v1XXvtUKRUAiLiK9F03BPAuy+7+jDKU+zvurPoLFI796oci/0/W6v7CCEr2udSC7h0YMP89KfTzPx64+AQMMaT64FT5B5GIZP/" +
            "BNjb40SBk8x+XavlBatbxwuEs8KiazvPVGMTwvhYA7ExdquhJmyznd59E4OpL/OYQtITWfq123pVmHvec/o7yDQiC8M2LivBGmLTqbAGY5FW8xOq68iLmWp4m5pcd7uYZeGDg2CG+346+sPUydY72w" +
            "JWo6vGU/u5l/JTth4Qy6ilWXOWGKRTkznAA3xXoSuLHfdjeSmls3j26FwDR6ysCa5+O+/2ELvvwgAb4d/he/wBd9PcuCwL1r63K8GdJBu/Vt9Tt4sv27dQFAvS1YKD8jijE+DohxOuxyMz/mVx5ARB" +
            "UDPIgKUDwinza8XV4JPBDq7L3Mx44/NhWWPkFIxjrwX0U/6i9fQATAdTwL3Mk8bpeOvEQdhzyBdq69iBvBvbms6j676vo7a0lUP5qJJD5aXQ+7dx1FO6lorb1ykI293Z95P9daFT8Q0w3Ap3UWvWKf" +
            "SkCDAYO/CFVZPPekkDvXp7Y+btmcPlM6Pr+j+z7Awf0cQCsUkL2B7Ee6d4oVwHudvj717MM+5jNSvoTR1758Rem/j7bDvFlFY7xpbZ8/dVeXu8q9mj4BCnSQPgsqPkFXyyo/YT1bvoQvQbt7Y/K+Op" +
            "sEvZ7mcjy2Rfi8K55mPJQmnzvZV6q6bow6OmSvWzi+SDo6ERY4uBH9Bbkv0oq8RaCpvFA6SLy/iP68CXTWuBJ2mLgTZYo68jKhuWG/nLlJqLS58eM6OP6fRTa7Taw9GSFdvZtdOTreeju78mJhO9s/" +
            "LLoXsME573GPOVxe17ewlii487zGN0dr9zdjsIHAuRzKwM1r374KuNy9Fj4evmcZT7/bAbc98Ln2vQtMj7zUJTk8nJSEPDQVVry0mDU8mos6P3n8UT49bps6o39oP/cwGUDkzEE8GkSIPA2rWrw5tx" +
            "Y8VZaaPYMllz8uAgM+vn29ujnYnz8QRE5AFdqrPCl63TzgUi88n/IyPR3EoL2lH1+9iPTXPr887DsbeGM/8uxZPaD+9bptdeQ7tE6fvdarh70MOoY/a6fbPrN3EcAiex69gTQ6QBXOxb+oKX48HkdB" +
            "vEluuD53Tag+/LNMv9KTHMD2ajBA3Vd4vXZe2jtaXxDAeiW2Pj0Nuz492sS+JCskvyCZ2L9RM9K87+NBvJGgZj/KZjk8MLOiPgFrfKs+e49DQX5CNz+55yC+XQa1vP+1AL/OryW90VSCPIbbHL1f2I" +
            "o8PHmvO3UY4boFjJQ6mCUVOLwhYzrB//u4g3VtuRs9ID3wZqK8eUFqvFpXBb1P87u6kX/gubX3xToGO++5Ciu4uYAU8bnaBqk4gOA9OEj5nT2HaVa9LXIhOpH/I7vocYs7f6lDugSQ1znwg6s5qSGD" +
            "uEVx2bdxbBQ4YloCOGhggcDinr7AtzfJvqFvxb2jAjq+93GEv9RO4T3XKQ++KOc9vDUe6Tz9op88Jc+mvDPGtT0ftEE/40JLPv7dajr/44c/huMMQD+oejwNgqU8fRw/vE1JYTwLN5U+hX+bPxrcjb" +
            "32Iaa78IzYP+ezPUD7K988yVHjPD6FLT1Ei509TzCKvbnhA7yvVcI+4cvTOzC3az+mAaS9l+S9ujEtKzygbZG98rtzvbRTkD+kc3k+mnQXwB2zJb1QniZAp78CwIKmkzxyYd68cbi9Pv9+sD6G62C/" +
            "e1j6v+pFO0D+dlu9Iv03PK31CcDzAa4+WTi0Po2w/76Caky/xD7Rv1Zh2ryOdCK8NIYwP7cILzwBuaI+Afdv3j6SUE1BNz1PPxoXgb05wLq9DiQJv8xEO73lr5k8zZFlvW3fuzxZC5w7TJAku9+YJD" +
            "uHRIk3oV6fOn1DlrkTMti5ik8fPk+rk7wNYJa8W871vFoiq7tHJSS6SDotO/HCy7rB8Aq60eM5uhMEgzkVO105K1c1Pa5pfb29Sxo69l1suhOq3zuD6Fa6BbD7OSH7zzl3vk659ElzOMNDXTh4bgE4" +
            "npygwDHJZcBdJhm+XCDKvXGZV77MBuC/1EYTPhsXL759bNo8z/6/PSk9mDyOWQm9tz16PrpkQT/yCUY+lXgFOjVLoD9O2vA/rTCgPMCZ1TwOB268JJm4PIlLUT/45ok//1oMv8NWZrz69RxAHc4PQE" +
            "VhED3O3408sL/dPWMYLT5ShYs8kfo5PTffJz7Jszw7FtF4P+Hs4r4KJ9Y6uUdJPGSdIL2At/i8aS2oP6rCAr7DjBXAiBspvXuM2D+FRjbAiNGzPB1wQL1oSrI+FnW+PgXMk7/i8qG/twlMQPluN73Q" +
            "Ip88284EwNm7oD67I68+fv8rvzQgbL+cZsu/nJXEvH3617uR0dE+fcM4vHM/nD4=";
    }
}
