namespace Alate.Catalogue
{
    /// <summary>Trim table of the swallowtail, made by the command line: trim swallowtail --bake.</summary>
    internal static class SwallowtailTrims
    {
        public const string Text =
            "AQAAAL6Z74gFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+AWc6aj88U0NBYwlNPwWqVj7GNak98cp3vh9Z7bzFWV08Yw6FvRZZVTxMI487reIdOoOdRTuTx525gXWTuS0ZCDh+cSE5dq" +
            "XmPlsxDj0gFi69v4Kvu23ng7xH0O66i6QPO+1s9bqq+2O6gFaOuSx5hzmbVTu3SjhuPeM6gj3h00C8v5aBOx+YOztpyZW6BEMSOT5c2bnqYJi5yhXEN9uOmjhfrX24a5GcQHcXkMC3Uhw/f1jtP2gM" +
            "hb4/jTO/PGwSvkvDjL2vEsM7/qIUPgChoLtwxw+9Z7CfP0JqVj/gjjpAPodbPS/4CEAW6Y2/G0YMPXvEMz5ox7C+J2ZwviGGoD+usHA/9gcYv+z0jLzCMCFAN4DqPwS6Sj3Rrr67wqsgPouUHT7DMM" +
            "a/o07Iv2+MC8HdQSy+NCpIPjPoiD9dl6y8SBfwvktylD+PCFs/I/L0POfgCD/3U5Y/VNG6PAB6m7/vhFlAxXzLu/2wSD2dFSy+xTgGvu3F074lREQ/ftejP++D0bwwmwg9Ld6IvwMNTT7eFq8+POSM" +
            "v49hP8DBunI/tO6Nvf1ZHT2tE+Q91ImsPY6cdD4BhqJWP0g3WkHM2Go/lWwQPqif1r4v94q+DGH7up1TwTzwZ4W9nzKDPN4SqLqlwLC4pIJvO0WKpjmbN6q5qFybOSoKRzpj16Q+U8bQu6Y7BL1ZLx" +
            "A85vNDvFMFoToumhq6OYVOuz0G8bm1jPa4fI2JOLh6WreJjrm9t06vvXmPILmzp/A7IxE6PKdneLoXSMi47G5zOsES7bl0td440F19t1bkQ7f7V+zA7zv6QOyepT/Hx9I8S4GDvhgXR8BUZbY+Lqgk" +
            "PUAQWz21PG8+UTDYux7CQzyrW0Q/fkHkPxXHEEAYSUI9ZlUCQHJg/j6p+C49M781PgUHdr5arCO+H8a1PzPDdb+WbMS/BPdIvQ+JQUAagLy/3RLLPMEx9b3ZgUU+ZuOdPpgdYb6zSKDAyN+0wAYsB7" +
            "6zRjq/Cl46wLfvFL1Wasq+b/MeP+PTGj+qGhk/idhZwL5UnsB5AwC+ZfCHvxFkwT/LzrG8IO3DvvKfED/O5hs/wv7Xv9XucT89gypAtmYIvYjbeT3EJc6/xfCkPqQryT7fWni/41ZvwO2AeL/uAo+9" +
            "xR7iPJpeIj8PlSK+fPWwPgH0hms/WZ9kQfxEgT89/B8+zzIEv7APar66aRE8nTK0PEYbjL3soHs8uaM8u+O4O7o5fGI72EY8OB3qdLkNjPU55PNGOkRhqD7cYb+8CHsFvaV5oDy6j1S8sINBO6qWRL" +
            "oKiKK7J/4zOIe0tbml9ZY48SttuD4aAr6UY9y9wVGwO47JIDx1fV88AJ+buthCJrmx3p86AeIRunu14jgTyFE1JE5wt4DEG8E75zdBIkboP7msfr8l2a++Oil8wHjH/z4j14g9rfJ+Pbvsnj7koAu8" +
            "OlYWubJNKj/pLOQ/CN0AQIRfKD1PsABAL70CP1+PIz1d3So+yW9dvvWk6L2s17w/hFqLvi6W6L4Qlri8QphLQGRq07/tDIw8Sa9RvdVzdz1u+yE+zjYcPviIk8Aaho3AeiLOvU4+VL91kTvA+AcwvQ" +
            "Ognr6ch+w+xCHRPr3nlD9/kHTAqtKIwPzy3L1w99O+lZQ4P0CV57yREqi+krfsPutI9z5M3xHATRJ9P61GLkAygum8pTGBPWEz2r8ZT6Q+Oou7PmAPmr/aCWnArOqAv6oxab1VBr88JK+WPhQuTb6d" +
            "rrc+AAEX/Sw/3r1CQVFKQz/y7x4+S0z6PUREqb7W6Uu9LAuBPPNCab1KS1c8LDPLO/UILroXX6M6v+cmuVyCwTktVwE42Fa/uEfJmj5jcR09GL+qvHEagLyvBye8Y7WBu0RBHTtOhH+5PZU6udvvM7" +
            "rIj802VR2aOITmpT1cQnw9nTC0uzrvHjt2ObA6h3HButetCjoWv2I52BIVuev5VLmtGwc4IaXLOMOpl0BwZMfAGxDDPlTaWz89SLa+2VenvnNRlj065jm+1xq9vWvXez1PFGM9iyOwvGaORz8hCF0/" +
            "POoJP7091TsiVQtACNnsvfx1AD0lCz49n/6ovPUrDLs0x5g/jwTBP8xJgz5REYu6/3Q0QGZsLz8bGmI945c8PbQvej0cSn89jbiKPfitEr74b/U+0LYSPHeO+z7SNcm/cuzIulaIxTwOKIu95RFHvZ" +
            "ni3jyWmzq+wBhQwHkfd71I9Mk9349ZwC6fBz3pHAW+Nxb9PvL5rj51A5m+jzV6Pyqi7z8djMS8x2TEPKH2vL9U7Ig+f5mgPsmiMb/LkjfAvlP/vcepj70Ndo08SQAEPxRB7D0PaKo+AVXiYT9nU1JB" +
            "/fBWPzMOBj5vJBu+a9yOvsFU5bzIamU8K9OGvef/hjwn3Dg76oMeusnbBTuCZX45jD3KOe9UK7k/s1o3JMvCPmS+vzwoiMW8f2DGuqKOjry5C6m6Zd1dO13UFLu69nS6vmdJuoPe1DnxwpI5IjQivP" +
            "4Mjbymb4+7gOlCO8Zm6Duyvzy64m4LOvtmLzkBQrO5k17jOAt+pzieifY30Je3vx0WUz8X6gE/4ok+PyBfQb7/me6/3beEPZ1ASb6Skko9zsUnPiGDkDw0A0e9BGJJP1QKaj/x+Jk/xPWlPBv9EEAM" +
            "RIA+vOPbPHqorz3e1gy+yYCXvZUN0z/7isq/MPCTwHsY0b28zu8/gd7pv1r4bz0Cnn2+9Rg/P0SiJT9k4Yk9ZkQiwFiGm8CJA8i9HnATwEhn9L/IZFo8VcGIvniWNT/w/ws/VhVZPvQsJT968uE+qB" +
            "7bO3Tm1T3rL/M/QNXcOs74ezzTj4S9RLPivPV9bL/tPZ0/y54TQE3c2LzCGDg9DMW7v3ENoj482r8+odaGv5HwP8DiZDe/FyZPvUCviDxEU2M+c0CzvUGdiT4AATIUDT8RRT5Br4ArP7xusb0Pgeg9" +
            "38m8voJiVr0gAj489S8pvUThMjxMedw7Hht6us7YLTmiKwy44wr0Ob8NObig4li4G8oFPi41UDzcYi+81PawvJUjebvFjV673UWJOjns7zlfjkO45tYNunKRHrg03Uo4q1i6PXkD+zyJlxc5f2OHOs" +
            "uvhjrwDtW6rOnXOdJ38DmbqLu3TvVpub7LkbXQ6as45k0TQDe12sCRfiE+vaS0vITsw75KsHe+fYQZPmrRCb7cb8W9KcEePEZYOz2vtCM6U8zNPiFvfT9ZrkU/G5wpPA69EEDzsoQ/omOOPG9JHz00" +
            "45y94I4mveYbDT9LSMY/zm5jP//dLTxiPylALEjzP0v/4TyaHkE9Wi2AvS3d4LweFRg8L0w5viZoOz/3MVc8jydIP8p8Sb8OQra7JLC+PNp4Bb6ci6698G3GPpjX2r2KRUfAtHZbvep34j8m1i/A4p" +
            "yxPOUFpL09ZQA/CTOlPn2n0b67Gqc+bl8vQK10Ab0s6KI8jloCwD4rnT47o44+1HWKvhUPD8DW84e/BXyHvdowmrjoymc/4Q7pPWTG1T4B1/8uPz/dSEE4Qkc/OWU0PZX/jDxcjsS+DBNsvRbDVTwJ" +
            "+229geCBPDVHzzt0rqm6uOufOrYSB7hEwRU6qU3muOqBR7k+95A+bNnAPHjJjLxYS5m8qyAmvO7pg7vryT07nRDIuagEpLlHAoK6auvrOLQKgzn0Cn89jgpHPJoXvboEilk6AFluO28Dtrop4CE6ed" +
            "fLOcq6Frl2FAe5cJpSOMofyjjw5HY/FxCewNnxCT7sSm0+dEKyvrO9aL9mQwg+z01avo8qbr1TXo49z7B9Pe0S/7zSmhc/nrJcP51y3D6FXY07ahjkP6K8az8eQdg8J0UTPTRSubyeYBE6baCbPzpZ" +
            "nz/Ggxu/tvaGvAhTRUDBtic/yaZZPVRpCTx65ig+eTQbPq89wD2KAXu8GJ1lPhEjhTvd/wQ/Ukiqv5SXkDvUi6Q8xVAfvSoY5rxrgSY/1v3Tvh5GS8A+sGq9mqxNPjejVsCnmOU8/ijxvRdk+z4P37" +
            "w+UOYPvw8sHj9hEy5ArFwCva2N7jw72dq/LQujPrE2qD56sTu/LMgTwLnFh7+IIkS9z4HFO2YW8T4kT8I8htiqPgABsiHiPqdCPkFtnyg/GNQrvp6fZz3J5NW+oGFJvV8xODz7qg69cbtGPDUdzjs5" +
            "bY662CxwOcnfbDb9piE6b7N0uHz32rgFR4Y9vG2yu+pmM7ybCdu8aZghu9a18bpsVIo687RFOQGfG7nOAwu6se7Gt86qaTiU3bo9LpRFvMVkhTo/hdi6LRMMO5GTibqfaNY5YHyxOVN72beIK/64/s" +
            "umN01sYjh82We/FE7bwIURgb6K/h6+hfZ8vsnFAL+7nOI9LLoIvqaxVr26zjk8jN/1PCDmM7zN5SM+5i5VP9L90j5nUJE7MmrVP95t8T8FWlc8hG+2PN1gFr3aV0G89HiNPhr1qD9Nt8I+Pw0cO9d3" +
            "CkD0fClALKu3PMGO9DyHRxC89p2APJ1G4LyFOKm9BoUIP10EGDwrFnU/lMnFvgFp+bojjmI8LDvIvad7kb0hlU4/KHjJPUfML8AIrT299hAUQB/8D8BP4m48R44mvSj53j5kT6M+7fcKv0cVdr9egE" +
            "FAwVw/vVmAgzx2yw7AUeWwPlM9oj6c5Ja+/wfJv+bzxb+R4z+9nooEvFolbj9qu4A9zjrKPgHD5g0/oYZIQSqcRT9Bn1O98VCNvKJ27r60bHC9jyxvPGlbWr0XyZU8ikDQOwO74rq/B7E6lPMbNu+t" +
            "XTr0iBm5BjWBubY9TD5bfq46jcKHvJR22bzmwuS7+bQfu53NJjvdFB26CHa+uaEeZrpEGQ05ayRgOZL8hj0Pl7q8vZ8MuAU/fboGKZc7HyyFuv08EjonPsg5Zz4cuRFLgbjHNl04ycuiOKXc5r/wEa" +
            "fA67EgviZCoTuv0IG+KuiSvy8vCj53dEa+SrHvvH5ehz0i6TM9f2L1vDDYsj5TIFQ/FoedPlaNGDuug8k/h/THP9FxsDzCs+g8Gd2UvGwQCDyJXVU/ZW2cPzakv77otje8IfgtQK+l6j8YFiI9jmeZ" +
            "PLIl1z24DAA+b+ukPLLVDD1vJ6E+YHm0O4K2YD/G2TO/1yLeOlnmnTwhYHe9qvA8vZpfgz905mm+6KQywOp/R72kE64/SihCwCXwujyHRp+9OkLdPpYcvD5lekW/kFjXvkwLRUBsLiK9ukzBPAiy+7" +
            "9FDKU+G/yrPjzFI7/Toci/OvW6v8uCEr3idyC70UYMP0sofTyKx64+AAHCfKs+eY9DQYNCNz/65iC+Nw61vNi1AL87sCW9X1WCPHHbHL2z14o8cHyvOxUs4bqSe5Q6dzEXOHv7YjodHPu4gNJsuRlA" +
            "ID3+ZaK8KUFqvANXBb0p+7u6OnXguZL2xTpvPe+5fCW4uXEU8blB+6g4d/U9OCn5nT3jaFa9Z2YhOtL8I7uDcYs7xLNDun6c1znQfqs5kPuCuDkb2bfvVRQ4cF4COPxfgcCgnr7ACTTJvh9dxb3yDT" +
            "q+2HGEvytC4T2WNA++I5Q9vEPc6Dxaz588h6qmvEbGtT28s0E/8EFLPpreajrd44c/LuMMQAiqejzsg6U8oBg/vGk7YTzwM5U+H3+bP4nCjb0GG6a7VIvYP7G0PUCwLd88eVXjPFl+LT2VgJ09niiK" +
            "vVHLA7x1UcI+YcjTOwK6az8/C6S9yPC9uooqKzwTa5G9ZaxzvYNTkD/ca3k+LXQXwEqzJb3yniZA4L4CwECqkzyNZN68Hbi9Ptd5sD607GC/CFf6v+VGO0B4d1u9ifo3PLb1CcA5Aq4++Ti0Pjqy/7" +
            "5gaEy/LD7Rvzdh2rzxdiK85YUwP2sJLzxRuaI+AbZw3j6WUE1BKD1PP4oYgb0UwLq9HiQJv9NDO71Ispk8UJJlvcneuzxgEJw7x5cku52tJDv2BYc3TV+fOtiPlrmJPti5GVAfPjauk7xzYpa8CM71" +
            "vCsbq7vcGyS6CUEtOwzRy7osBQu6e8w5umohgzn4gl05+Fk1PYhsfb3wgho6E2VsumOu3zsvvVa6QLT7OSL8zzncEU+52LZzOPu7XTiy9AE4/52gwJPLZcDbJBm+HpfKvRKFV77lCeC/JV8TPo0ML7" +
            "5Mr9o88BDAPa4omDxtRAm94D56PoxkQT87B0Y+02kFOqRLoD/u2fA/9i+gPKqY1Txg/2284524PAFLUT8m54k/MFoMv3NWZrza9RxAWM4PQIhfED1G3o08jr7dPZkYLT7ofIs8uP05Pc3hJz5Wtzw7" +
            "5dB4P9bq4r7ML9Y63EdJPOKeIL09u/i8gy2oP1y9Ar7NjBXArBspvbSM2D9pRjbAWsyzPHRzQL1QSrI+3HW+PkXNk78y86G/lAlMQAdvN72xJZ88z84EwN27oD7FI68+pf8rv3UfbL/QZsu/O5XEvC" +
            "Ly17ul0dE+Z6w4vMg/nD4=";
    }
}
