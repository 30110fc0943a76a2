namespace Alate.Catalogue
{
    /// <summary>Trim table of the fishfly, made by the command line: trim fishfly --bake.</summary>
    internal static class FishflyTrims
    {
        public const string Text =
            "AQAAAHxPhA8FBAAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvpqZGb4AAAAAmpmZPgHTqRc/6vOSQQ24dj8qCXY/ij8lvbpuArzHSPI5SoZLPJLkPb1qs8A61vnxucIs2LqzJi86TPQhuZSVSTlykjS4jA" +
            "1LOqFYVD6Nuw09Q0W8u+e0zTl3GTm8N9cKvNSmerh17gC6T4SsulSpjjmaUGs5yWNqt4ct0L2eh2S7dHkJOhD4SbmhGWE8nQhVO7Vy+Ljloi85OyIaugBYnrm+Woi4NrHCtwyr2r4XND1BEscjvQVg" +
            "x71Lvpw/q+GgwJqC/z3cp089fkNBvjtfvj63zim9wKC9PEbtgD+vXcw+VmNjPwslDz0U6fs/IrPaPqfJmLzprAc+9SKvvYt6F77nCJ8/FaMav/Musb9dNKq9AJkcQPg5p78YM+E9XjyBvpFowj0vJu" +
            "c+8n1bv9jG57/FYybAUk4gviSlvr+/qQrASjYfPnMfC7++QpE+GeVWP3hlVT4xu/O+E6qsv2E8CL2VMLk+zt2Tv5dEBz1r76e9A38JPfTixD0yNKm/xl2QPVJWwD+yfSW9fHqEPd5SNr9cEx2+jX7E" +
            "Pn735L5HkyDAOSwePxSm1bw+4448lkoEv6Prwr1atBQ9AcuRET+rKqFB2klwP36Fej8zzkO9jUAXvFtxXjn0Dzc87OgtvcTX0Tqd6+G5FaeyutETzzkq1wi51i8eOZp7qLi5U0I6SVZGPm/qCz21Gb" +
            "S7e6cWOq2mJrwdMgq8LEYyOFpiK7r8PtO6uLgtOCU9hTkv0a04gRmpvVPbBLyNNoQ5zy1fuThZNjyX9EM7/N9QuBtAcDkpSci5iJlsuZCEyLczX96317CDvzaFKEEQtna9i5KJvR7QnD/4BZHA5EIC" +
            "PhHLtjzPZzK+93ycPs3LB70XWpY8xxxzP/ju0T4cpWc/X9kXPRjN5z9qbQM/4nAgvC2V9z39lqy9wBoFvlJqzT/1KQ6/ryatv/XjpL2j0C1AEC2Ov9R1oj07fUS+DT+uPe12tz47sgG/AlTtv9ZvL8" +
            "DnFiO+2tC8v9soEcABdtY9SqvlvtUtjj5rUy4/NY+oPjGa0r5Z7rO/AWTnvLdT0D4z47O/zkqIPAfFX70Wtac8d79xPVIPk78T44y+HZmiP6m/KL0Ap2o9a/hWv/2ITzisFao+Rakcv1dlK8A7pDk/" +
            "jF3UvKROgTzvtN++xJAKvpJJNj0Bpx0WP8hwoUHJwHg/aNt1P48YxL0aaAu8n5iwOaEtNTwgVCy94BvZOn28ArpMhby6w7gkOYtIMLlm2oI5j1IEOO7JQjrX20U+u54EPWVDtLsjBiI63mU0vCowB7" +
            "zxVBI1J4squgD/0LroRfg4boaXOaNTGjguUK69ng76vMpKzzk6Q5E5Z4Q8PFEAYzuG0d24d0GBOa9jzLmOB1O5glnrtwmcKbhJr3nAhvUtQUh/kz3C9M+9rv+0PyNOlsB/ARA+l/t/PQMkIL5HzJ0+" +
            "soszvUac6DzVd4w/nQ0xPwWuhj+xkzI96fT+PxtNLz+dZ5+8Gz0aPsYpxb3UnhC+G8DMP2XYV79bN6O/87ifvcCQJ0AbyYS/L5zEPTFsU75xI509DISpPjj3G7/6aDnACv8+wNKWKb45vLO/q7j5v+" +
            "9kGT7FjQG/sziOPn6+Jz9tbNc+9hchvwd+0L+9XCG9UffoPqGZyL+DAZo8VS62vb11Cz2LEsc9R+vEvxO9mL4P4qs/zC4nvU+Ebj0sS3C/ee3oPODZlj6u/dq+kq0vwO6Z+j680di8pvRhPJ7d9b7d" +
            "E7W9XYUePQH+kxU/64GfQV77gD/KyXg//Z2vvcqOzbsWBJg6wtE6PBPzLL3LuMk6zv5PumU6x7qBfAo57wMpubBpkTkBffo4NG0+OoalQz4C8vM8UK+2uzxcJzoV7D+8B5n6uxrXDbYUliy6Uiyzuq" +
            "MRITkmD5E5GiWDOOkjvb05r7y8zyqpOfeMiTnpaEc8igxaOxIxnrjyi4Q5qc/SuXKMPbn0uKO3D/3gt/4XOcCtdTpBip6fPV3BtL2bI6w/AjWdwLKsDj6kUC09zNMcvvQFoz7qlz69DWgSPRvSkz9E" +
            "WDM/zUF7PzXNNT2nxgpARhFNP8QNsbz3Jxg+KMKxvQcdBb4xR8Q/outSvyPpnL93QJy9qqYqQKu/gb9I98U9FadDvvFThz3ZWpc+XPcVv+JyNMDMKzHAOFckvn0Fi78zEBLAyakYPsNk777CHHk+91" +
            "cSP2Gu7j4Jvd++4jK0v/Ga27xZYvE+s8vCvwjEXDwx1j29nzj2OyZuOz1Rr9+/xluuvgOFrD9l7ii98m9uPRIajL/qoGs7ps2kPndl674FgTHAVBLDPqSa3Lzadmc8xXHCvvBx+r28M489AUnkPD9K" +
            "IZJBvH9UP/0rmT685TM+OZsFvgNspLwOVUg84lsrvbv85ztbQWw7COuvufPDTzqF3Tc6GfAsOZg2Dziet2M5e+jzPTxMsjy9YZu7R2wKvLtXw7v+Q1W7vyW4OGizuTrPZ8i5Ju3GuTrfQblZQm45JC" +
            "esveRpBz4Ne4Y7rBZTvOWmGzy6xT66H4/PubXLazppCpG57TJxuJhRa7jFiBc4NVx0QY5TG0HnIELAEvd2vxkAiL7/7F3AmifsPhtfTz6ylSO9c45BPlkbBz3EMEc9HDx6P7aqIL4r/Aw/pZ7SPEJN" +
            "EUDjJIC/OIL0u7HV+z197Ki9/YZQvurP2j+U9qm/sceQv736SjsnICRAv6qYPi77ojzze709IxRhvT+1Qr5dpou9n7lTv02E877UO8m7tDw8P23OJsBxdIY7PU6fvI3duzzb9Dw8OmJwv0dvij/SuM" +
            "q/BPOUvdpfpT6pSsO/sT4pPVxul740jTs+eicOP7GNAL8Hie4/wcrYP4Uqyrxi+Bk9UkuRv0abUD5E+cE+vCDWvZwBZsCPOtw+YN6QvTieQj01rRc/Rm+bPSZHuT4BgvxDP0RrlEGayF4/p/HRPi5L" +
            "XT4ygNa959l0vLDZNjx3uzW9bJbWOwG7Rjt2Stm5cSbLOsgr+jngdqY4JRNQt8SmnTkfZgw+emW5PJMAurugssi7QzH4u1+8f7uoc4Y5YtNxOvQI9rkAR7u5b159uCRaHzkbjbW9DAAiPs52Ozt38z" +
            "u8m9InPNoAxLoY2mq5HzxfOpsPtbm9h1e41KNAuOIgATiih5RBWXYmQawiMMCpBC+/IJUOv8UVdMAQmOc+zOn1PYTs9rxUsXU+QZ7nPDTsDD004IA/BlLXvkWFMD8swvg8vnH6P3ZRTb+9WBK8KkYD" +
            "PkMQrL3dIl++oQTkP6htHcDW2J6/XUUuPH3cIkA18em94a/4PKW65T2kMkm9WRt1vp9PJr7TlgG/Lqswv0zGnbw5+SI/Vt9CwJgAaTxQuoe9QHRmPaBQ8j20Emy/ncfPP15k4b/AxJq9I33lvFayxr" +
            "+w1S0947eOvpC7Kz5XIAc/ATBqvtM7zD+bwOo/uWAKvSBVTj0WLXK/ts44PpU21D7tA4e+M5hwwI1r6T58D2O9XUsdPc/ywj4X1dq70Ft3PgE7vkE/BI2VQb5CZj/Y2gA/Qzt9PkgXsb1vHj68WQAw" +
            "PD91Ob3H37o7qPghOwzO27kZeOs6hrmWOcmjfjaihHC3ONOROTdVFD4Gzro8zQ7Euydhl7uRrQO8DaaIu1aEaTlJ+OU51QrOuRCDfblnUqI4K1tROFZSu72jvDQ+oLf8OtQvLbwelC48k1vqugXvhb" +
            "iREEg6j3y4uf3LZ7elUOG3HDwaOIH2pkG2/ixBnjMjwNi47b5K5Cq/LxiAwEEUzD4wKho9rP0nvAzpgD497gY9zCqMPCgdhj/PCSm/oLeDP8yIHj1AH/s/CFE1v6awlbxdvRE+/Ua/vURXe76PpOU/" +
            "jDd2wEKStr+Xv288N2wbQLorHL+FsxE97lz6PctB07wQmYa+XWK9vpdsSj6z/sq/OOtUvVwYtz5cKlTAaJcqPdW4Jr4vIAI+7e6jPhU7eL+3dhhADoEGwGjErr3/+t++ws+ovxnRYD0izJC+oQosPs" +
            "GXDD9NFjq+ZmKhP+du9D8vJxe9Ea9ePR33XL8ED00+/obPPmLeoL7IV2rAes/TPj5VNr0LkAA9bNKRPtl3wb3CDCw+AROANz8W451BlnJwP++xIz87R5k+sYKBvbg4BbxVN0A8i3A4vUiCljuulPQ6" +
            "YzlQuuhWADt/kQc4R2JRuGAKBjkl5DI5jlQaPmYYvjzjWMe7Pn1Iu2Vb9btv/aO7rg1POXDoW7mQTZa5PeSbOeCKvDgou6Y4L+qsvf/1ST5QqkM6jiYNvLGNLjzBgsa6I+vOODJZHjpDdt25sLDRt6" +
            "tqLbj5tAY4YRvFQaHLKEEkowzAkxhLvr5NG7/0/YfA2wCtPpQahr1k2Je8QhepPrN7qTz6ryA9afKBP2ZJqr+S5B9ABsWMPRAlDkBfvHq/ePKrvdeuQD480R6+gHSwvlK01z+2aczAgyzsv5vnlDyd" +
            "PP4/s7WqvzEukrxMFuQ9yfDMPOq9i77yN8e+XhnnPyOWh8BjF+m9RqyJvZSsScA8fCI+DiyRvhalgz5b/BE/sGJjv/d3XEDEd0vAiJnLvQlgkr95tyK/MtjoPfgPib7qIUA+XigHP6wlPb05HHM/IG" +
            "EOQJafI703LGY9ohFbv1bOUj55NKY+eN5YvjY2cMAyVEU81kQDvQ8gmTy+j44+S0LYvUCXDz4BLYkdP5fHhkERtT8/t33BPHr0wT1p4CW+wIffvOplNTx52QC9XbizO8bnFDuoRTc53eQLuhJa/zkw" +
            "Hzc42EUNOfGKQLgRySc9QzpGPOJnBrrZ4iq8xuOsup1cGbo2tpq5TZ9BOvSXFDnFCu+4TlrGuB5+JzlpT4294HWCPU5DujtkYoC820vhO44zATq0T2y5mVooOhjuo7hwyow3OMlFuJ/xcjjo7dhALT" +
            "XrQNmBWMCNLZ6/K3MjPtLPEsDutJU+8rDgPSPCrjx+f0Q9Du8mPXky+zxzn1E/dHxSPuu0nLxubRs8cWQtQK9qHr/k7aQ83R6oPVE5TL2vnIW8tpCQP8IH8T5k5AW/aDtmuyfeNkB8FII+UcnFPLUL" +
            "Jz39A/a8ukHLPfnkDb1v0WW/kOwdv0SuWLyEWxQ/OrgMwKLbt7t184O94Z5ZPfM3pDzQyn6+Du0MP+nOm79QY4e9p5QAPwGcaL8Ibvq8DqKwvrhKUD4H0dw+QaOKvwS90T9SIB9AJPc8vOGysjyose" +
            "K/Q4JNPuzffj46/Z0+BnYswMq0G790xKy9OtYZPTlsRj8Syzs+Y+8dPwHvbyg/D2iMQXe/TT9yWuw9PnPzPYQxIb5ObtS8ayRJPIVpEL0gONY7JLM5O+ylDbY4gY83Y7MOOrTCpzjM0u84nmryN35s" +
            "iD2PloQ89PLculn1Kbz1WDG7jsKvuiKng7mQQ1M6s6l/OJC0O7lmKKO4rnMkOdpJnb31F7M9S46qO39ff7zwdAU8f8SROclrVbljZEg6gTYNuYbmuzf1Wj24/6wvOAY1G0F2SwhBPBVhwCzJlr8Oar" +
            "49fRs2wNbauz6YvNM9ZouXPCliwD3CLDQ926EPPS/GXz9uvrU9NPulPRWEazzarxhA42j/vvlwKTzyTrE9g5BOvTK1cL2yxrM/7JMfPh72Mb9mBx27uzlBQF3g8z1N0+I8b8pBPfOS2byQGwk9+D+K" +
            "vci7Hr87MRS/vSiPvG/WNz/XDQ7ADzOJO7cblL2dT2g9F910PcYMzL7E5FE/m9O7v7U1nr3nGLw+NQN5v+B7pDzmiKO+Log+PsNA4T4aXoK/J8LcPz4DG0BYiaW82j3bPP1T0L/ImTY+ZmiQPkwVmz" +
            "7EhkzAmBEOv14On71p/Q49qjo9P9z8gD2y+fs+AVexNj86yZBBuztZP5g3Mz4DAxM+gy4XvpbFw7wj9Fc86GwcvWxv5TvMaFI7+YCUuaQcBjqtewM6qFAeOI+v6Dgr3gE5a9i0PZcLnDzR9S67J+8h" +
            "vHYIebszPwO7F8gFuWmeNzoj31e4mQ9QuWNqh7in/xo5AJSmvcY33z2nVp07C6ZyvFooFTxC+Bg5ZNZGuWQvXTpc7l651LeYN7zkL7hT5SE464VHQbnzFEED2FzAWaWPv5VvRj2erlLAr7bbPqIvxj" +
            "1/l1E8nPUUPkCtDT3KaAM9FjRgP6RryjyFiJA+tLiQPJ+aEEBYmKi+buGJuv4RwT2Dy3290UXVvQc1xT8p8Zm+v15lv422i7ulU0RAwfwdvTug0DzszC49u7SMvHnbBLwmhtG8H5aYvipYDb9YgJm8" +
            "iixKPylGC8A/6GU8ZGaZvRLfgD2KNtY9kH3Evr5upz9iWsy/eJuZvfIBYj5gOIW/DXRdPfChmb5u4Ug+zZ0BPxyoZL990ec/dPkbQLFqxbyZMxA9VbG4v98ZcD6QFqs+Ki6SPvgZW8BHi8C+MWyMvc" +
            "TEHD1dhCQ/fJZPPc5h5T4BF5RFP3Crl0Gsv2o/KO+NPmT2Oj6FgwC+95SmvGPicDyCOCq9K4HZOw06YzsBdEe6OrWaOgdzcjkBAA+5l1EtOXYm8DjRoe09PJq9PItnfrsVbw285aeju0KVW7t8aoS2" +
            "1gMxOExr77ipTom3r1DVN/pmADn5na29OEYSPlLncztg0lW8tQUrPMS5HDjU4gS4N29SOoeulrmnoIS3dj/GtxWMuDbgE4lBQaYiQW9LTMAIHGq/Hg6yPOWhfsAgeOE+5VaRPP5D3bnm6Fk+Ghp3PD" +
            "KmBT1xCWI/Tlpsvm6rIT/EFr48yRsNQPMTBb5LMHa8FgffPT4wir26vQO+YEHVPz9Ztr/VuZi/TfVAu59zQECduue+xBHKPPZGPT08Q8Y7qvmLvWxy1LzQirI+v6arv2NoJr1W3kE/6XYOwCU1RD3I" +
            "Phy+5VLnPe4xaj5PqeK+y1UOQGjUEMApFae9WthgvTfFZL/dx7U9WPedvomDQj49a/w+Vv5Sv/K85D81cxpA6GIAveO8Oj1506G/NxWcPh7p2T6Zr6A+/jlqwBqdo75Yo069i88FPfl7FT9ZuTu9cD" +
            "uKPgETVPM+toSEQei2Jz+kvs69lGMMPW70FL4fO/W8JoP5O9gtqbyVklc77GxDOhOAUDnA3Im5fu8TOXQcm7fIC7U4j36TuKPt67rXa+U79hjLOvfQKLwhnDG5ehMauWfE3LhToQQ4gcv1OOxDEbjq" +
            "HCC4wR2KOKY1I71AGLk8N2W5Oy+pSbz0CYc7zPomOsi/mjclzpA5u6GJt7teBTgkb1K3WChEN/BzF0AUZoVAtmUnwK0Vmr/0T1c+vgetvyXnAT5m6wW8MAenPH5qMjybQTQ8OfA7PP/5+z7omvE+EF" +
            "T3vSrNWTtVSS9Asv4LPuY7PzzWMyQ9mN6/vDea/Lx6ICQ/8eFGPw6KtL7/a8m7bIhLQJOWWz9bvDM85q8IPEpeUryQQBc9LZ+kPuN9Or+omAy/+KFCvGPIdz+pHAfAYSwku52APb0RkCQ9JgLyOvhn" +
            "lz4hczw/nHcOv5efZr1prBo/+acpv9zx2LyJ/oa+U9cFPp7a3z4UF5+/PtoEPzd5VUCCidO87bGxPObVC8DKDnE+LJhuPl53nz49RxHArlWcv7Vxo717l4U8oXQ9P7gE+T1cFRQ/AawGCj9CAIhBdG" +
            "VAPxK8z7zjhYI9SoIjvlcN/LxD5Cg8QeLavJhXnjspKcw69FIpOZwPsLh/p5A5rYrttj3d9jjLbDi4R0KjPEAEMjwvM6U6zYREvP1wR7q/lr65bkkpuRr/ozgnk9Q4lohXuB2VDbjVCuA4wXNgvZw7" +
            "ST1A48U7WSlyvOyPyDva7E06BKepN7goADr59m64tHpkONpo7rcWiMs39vGoQIZvvECI1U7AQLOov8Pzhj7WSgTAKxRpPsRPILynOgQ9TJ4IPVf9pTzMP6M8C/UcP4dQxD6+6uS92xG4O9EdJ0DR9z" +
            "w+3YVVPIj3Uz1Ok968ZXgGvVvrXD/0qBc/pi4KvyKp2LvchUdAvBNbP2lZizy+Jy88jnYkvGC1HT1yAIo+grkKv5ZeAL9XP0+89dJ4P0GZAMBXZcm5BC1ZvQN1Jz3j2eE8LeEgPo7jcT9nW0W/AF1z" +
            "veg0Bj+oOi+/+RIcvNvGjb6BOgc+nIzbPiG+ob8Vs2Y/gE5VQA0Ny7xrkM08MNcAwFAWZD6awHI+9i22Pl1tIsB0Kpe/9MmWvSxUtDxbZkM/zGvxPfDgDj8BrUAVP41xjEGqG1A/73ozPV5WqT26cS" +
            "e+jN4AvR+4UzyJQvu8Avm6O1IMHTtrAwi5RGxOOZkIvDn/bNy3PLsrOfpA9DdlMCg9xlZtPBWRNjrB4k+8lwW1uqAJM7oVQA+5O3evN1i3JjhWT7647X4juICx/Tj3xoG9wEuRPRBCxDvJVH68R7b0" +
            "O1qfgzpIB9A2CsIrOp9ev7h+xxk4afvotxbvpjdO3PtAgPngQG9GYMDuHK2/Om+zPl7hJsDgqqI+fW5Ou4u1vjxYhXY9KU6TPKI8xjxgny8/e/1wPu35or0/AQs8CzgbQIKtjz7IBEM8TxJ1PYOf6b" +
            "yr/g+9vqWEP9OitD6EPye/UDOcuxDRR0DQqmE/zXCYPFgKujz6/uS7PDGPPPVGhT4z3aa+ZmUBvwZre7ytJYw/hxXzv26YHjvG0nK9cdE5PV1rRz1Wmlc9isySPz+wir9XcoW9RH3sPkEGNb/W7K06" +
            "rz+JvuyWDT5w+sA+BuykvyOfiD+YLlJAUirhvK2i9zwRlPS/ivlGPhDogz77ras+D/EpwNt3l78gn4q9Q+vHPBfnTT+x8ac9eL8APwH65Sc/YCWWQSG1aD/57Bo+imLmPZkwIL7qJfS8YkqHPOLcFL" +
            "088tI7EtB9O8UoTbrleQ86eIjnOY1mJ7m6u0w5y79aOX6EnD2ypKU87slwujfJT7whchG7Tizcus2pE7mEzIW5ohJSuVVQ6Lgmp7u2crv3OLi/kL0v+dM92vmoOyNldLzVkBo8zcKyOnz5Dbhf4Fs6" +
            "oeQqucVdhLgqsb23k3nNNZWbREH8RQZBAHFnwCQfoL99bwM/LKVjwAMI5D6VTYo89bA6vSeA8T2Kx3A6AV6kPKzELz/UJ509vTJvPkJLcjz2UBJAIdi2PrkdJLykXpg93DUVvVrrd72AbaA/F92yvh" +
            "TEXL9zU1O7HwFQQDLUEz/rt0k8s5bqPJAjizuIM8y87Ft9PmwmzT2R1Va/b43gvGf0iD9nAeq/T3wTPVEzyr3lOoI920TpPc1NdDwDvdU/KRnYv+C2kr14534+diQzv3FHsj1EboW+AEsFPsVYvj5e" +
            "IJa/S7KiP7ZcUEBMQPe8XqIRPaTa5L+ZWkA+EVqWPtLKzT5rXT3AkBiSv1c1YL2Y8NA8UMNTPy9gfz0F1NA+AUBuvj72jYRBrhgqP6lACr53vJm7gCEQvuqeEb1Km+870MSKvDvXRjtmICM6gYPzOJ" +
            "17vDgwwAk5Z3/Ktpn2NzjXQHO4k7SdvIuXozvVGyQ7aE89vGCFD7iskCy5EOf1N7sdKrmeq8U3gklbuDEC6bZspUU45Le2vMUAETz8PMs7u6NAvNg+fTtqZWI6peTWOKVLcznr4Me2AknPN1XuHrbp" +
            "qCKz3RttPwZsFUBcDSDAy82ovx9NkT4JLaK/YMXZPb4PPr0Wy3w8vnxpO2XhNzkvu9k6xke1PpHTAj/E6HK+OYWvOYISHkCOqYU/mtINPNhayDw99xK8uaX2vPis1z5ElDg/Jn+tvn/frLvXJzZALe" +
            "PsP6tD+zscUOU7KAb9u3ilJTy84gc/Iqipvof2+77kgi+8EWLcP8+10L+wX+66e33+vK44wzwhVyS8L6QJPxuagT8qXSa+Q8FQvT1MPT9KpQO/r5/avNxdXL75hmI9EWfAPkjzub/TRUi/CMp6QP0/" +
            "P733nLk8F5UcwDjOeD6p1FA+0DqaPhs21L/GcuG/tDt4vfN0RjtSkHs/EDisPfP1+T4BMtrQPiN0iEGlUUE/3FI+vTHcrDzH5SC+jBsXvTlXKDwqOLW8JJaLO1i+qDrkTlO3EemCOeUoXzmsbKG2Ld" +
            "/QOEJv/7dhS1i7I7YQPOX/JzvZmWC8PkJmuaa8F7mIgSE4KdqQuUA8ODdWdcu4DzT7NkQcfjhu6xO9cpwDPXaV0jsmDmy8D1m2O1w+lTrjme84aXTtOcndrLcE5+c3Ya09Nheprzbfol1Aiw55QBwu" +
            "SsDKdrS/d0fFPkpP8b8Lp1k+KcVkvT5OoTyNKUs8zISBO0jBmrnsPOw+zL37PijDOr701T87KhUiQKnscz+8kx88h2kJPQB4fLzo7628MyYcPzKEFT+xXem+xIGOu30tNkBa/9Q/tCUdPFDiDjzJaQ" +
            "m8KBUfPI1k9T4mJZq+X3oDvxq3Trx3tb4/WL/bvwSTxzm94i+9SlAAPclfbbtBq64+SeSNP9IuBb+b92i9TBolP6/JAr+wLyO89KR2voAzrT0FhJU+jgnBv7v/M74stXxA+Jkbvd64zDzaRxLAss9j" +
            "PjUibT51qKA+cyD1v5ye2r9xRX29oRYOPEKAaz8EtpA9ECHzPgE2Cec+CJ6MQVXIUj+99I489bEePYMgKr4e4xy9THxWPLlZ17yKCaQ7Xl8UO5TOPLnr+bM5c12SOQMn1LdwEP04A6FTttumbTz+xk" +
            "k8h/s0O6Midbx9Xey5QydQuc3ro7hsJMu5KaE4t4NvD7ljlsE3RHfeOMK+O73ODlY9sg7VO9Cke7yRzeM7pvzPOsmxjDgEhBM65z4JuDMCKTeEJha3Sf4fN57IuUC/6aJAVi1ewH4wvL/CIg4/boEb" +
            "wO/IjD4AwAa9pHf6O2y9qTyHoBc8o9TYOw4tAz8Oa80+/tEivgcxkTsjpBhALmeFP7zNGjxukyM9mfRQvEoRA73gBUA/SQTWPu3zF7+Vea27ejc0QJ6j2T+gyy883egyPAUNIrtajE28/UToPkUf/L" +
            "1g8wC/hSBzvOD4xT/Hx8i/Ai4lO88eWb26IgE9ZNAIPQLOiD6pAqM/SnY8v0x7bL374xA/mBYFvxAeTLuMWHO+2MuXPUzysT7g88G/O1iEPJINeEBfmhq9HEfePIwmDMA4VjU+gXJhPq64vz4/PQbA" +
            "vwfgv+juc72Htk08g6luPz3aSj0fCdw+AYuzBz8JFpdBooFuP2Wi9D1NsIg94u0svij5Gr02D5M87M0FvRo3vjv5a407jRB0uvckmjnU5As6DQ1CufWpRTm1t5M5gAFJPWgwmjxlXcw6GXaAvFylYL" +
            "rN0GO6O9IfuULjN7ryRUi57190uY6lVDjfudY4YdNqvSCNrD3c1bM7ysJ/vJgWFzwR7Qg7rYl1tgvoWTqpZq24fw2zuOWberTodQi36AghQXAw20ASw3PAihWrvxeNSz+v+l/AnEXjPgvZlDoZbna9" +
            "zSpzPSmIBrxzg0y7pLkMP2CnmD6aMnU9azYUPFD8FECG94I/Eo0EuywDTT2Vuai8+TvVvGLrej9iEhi9CIE8v3eePrt/PEBAXTuxPxq30jtBsqA88x33Ok+Aw7w6atg+c5cmPe+5L7/Df6e8I5ewP1" +
            "Vsxb8+UcA86ZuKvUsiLT3X52k9Gc87PqpSwT8Vb7K/bz6Evejn0j7eZhi/V1iBPYZiab62frk9EQuOPuYIq78qp7o+ySlyQDa+Gr2UqAs9AGQDwA+19z2E7mg+CrDZPgZzFMDpH9K/ud9MvcVcaDyQ" +
            "BHU/famwPQm4zD4=";
    }
}
