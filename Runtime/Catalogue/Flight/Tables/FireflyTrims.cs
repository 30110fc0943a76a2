namespace Alate.Catalogue
{
    /// <summary>Trim table of the firefly, made by the command line: trim firefly --bake.</summary>
    internal static class FireflyTrims
    {
        public const string Text =
            "AQAAAMHijPEFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+AS9dMz+az2pCzfFnPxHnTj8Xwlq9gE53u7acBzknkvM68aJevD6XtTl1Ham42thcuJFtD7m3Q6A3d7VXt5QFgLfj/q84Tu" +
            "4jPXQHNzv27fq6IbjJuXiXLrswlzS56VJiOJY0nreqCdy4G8FXuOMP3DcMC8k267fEvFOGxDtep+I4JWLTuaeZQjuv6Q05cPgtuOW/GTjLBFG4YSo8tx5HtzUIMUI2oY8OQKa5DkGt2py+O5uqvefy" +
            "Ij5QSGDAa0p/PWDTkT3CN828+7LlPXihwjvhDOK7KIOAP4EJMD3jQG89eBePuWWwE0COY0e9lMPjOysw8zs5Xfy7VF4KPKI5jz+NWcC+z7DIv7J+ir3rPzJA5bfGv2ZJKDwU11C+P+u1PV/NHj6i4J" +
            "S/N+7yvRQW2L+jpvy9MMMEwBvvC8Dlt9i755DSvi5cRD5Zq4w+rp3QPvp/AL93bu2/QNkpvJzgjD8A87u/esLOO+90brzeBcg7zriNOwGE579jfNi+U1XWP3f0Br2dYxI95zp7v0vOFj7DtAU+3w90" +
            "vfQ2q7+Dq+M+u22evO1RiDwVJxS/qSWDPXQFfz0BEqQ4PxuKbkLIW3I/xt1OP0m6Ab1ERBi7J/8gOXB69zp5QFq8y66ROf3JkrgOeV24bYQnuVmujDcL9Iu3LGODtQ9MgDhO+Rk9HDAfO9sN+rpdm6" +
            "u5GIc6uwPAXLn1Ap04qUIvtppGs7h1d2C4BLjvN5vrBzeTls689Fv6O9GXIznu8La5b9hHO07QyjgyLFO4UZ4WOHOEPbi5UyC3+osdNh/JEDZ5gDhAHTkYQXSBib6qNPW9jgntPVDYacAObHg9FUqu" +
            "PYcPtLzzqdM9lzi9O5W45rv11pQ/gy6LvHPpyrx7cfe6Fh0gQBsWB77KXQU8lipQO1NOlrs+STw8GReaPxSX+L55lOC/muWLvXvEKEAJH8y/deUZPMu8S77Ui7g9ZIUKPtvYjb91xRs9L3byv+Kc+7" +
            "0ZKgbAVCMGwM6OI7zmH8q+VjQ+PtYbcT7vbfk+kjgqv4xH7r8B4Oy7NJ6DP2qYxL9+lfo7GD5pu7YjozpyEEG757n0v/jRIb8dQ7o/8EEQvagXHj2JsIa/ZPnvPVp9Cz7ocdg9zYq1vxtC0j5QKJu8" +
            "zb2KPBks5r61VB49QKaZPQFI0zo/JqlzQsvRfD9GTE8/QrRcvBYc5rpovko5wegNO9hiU7yts4E5goJ9uEGDj7gTJ0C5WXaBNxpfa7cBmE+3m2AzOPUvFD1Dxx07xY7/uo7yormBc0O7HQ6FuS0ImT" +
            "gPM7q1r8Y4uFLAhrh17tM36nK+NpQC1bwqjx48vtNBOZXdzLn95Eg7L6nMOD9carhGHBA4MyEquNcrb7c5Dts1Exr9NUu2bkAqViBBBeOcvgP8E7582Pc90hlwwFhDeD1RNMU9+uoEvSOswD2tg7g7" +
            "+QyTuwY3lT/3CCS9V2m5vfhkHbtG0DBAxvAevnEkBzzXqZQ6JjQeu/oDOjz6D4s/+9gJv0rp+r+voIy9SV8hQAtgz789TiI8ZSFEvoMxyD2m3OY9Jh10v7dBQz4vrA3As9z+va4hAsCcYwHA+dPQu8" +
            "hcwb7XHUc+rXlKPkzN9D5DHUi/shj5vwAtBbwJqnI/2MLNv8KI8DsIpNa7e8VYOwpiHbuCsgDA8xtYv97loz8Ehh29NAspPcrhlL+Ye8890kH7PYySmz4H6rq/28vaPpWpk7zH4IU8V6GmvnU0HD0x" +
            "Bqc9AY8rMT9zqWZCtSRdPxXBEz/johk+Y6fFvHq0PbuYH1o7yPxZvIquvjoO/xM63B2ouAUgQ7gDHsM4QlIbOL4ZDLiXEks45AwNPcmHyjvCz+y6lzyzuvhABLvYkIq6fGU2OHnpsjU6THS41d20uP" +
            "SnDDdLFDs4LyvWvHsczDyYkCQ6syU5u4tmQzsfqws2RvGuuFmMMjkIUCm4RyzntxQsoLZH7xk3t1YRQVqCGEH1YgbA9x7vvlElGDvF3FvAjYmMPvIwCT41n3G9bfGxPTXU1DyG1Vo8xlCjPwgjrL6B" +
            "Pxg+dv7SPEZIL0D/o8e+nMEVPOrP8j1dGW69+1y/vaoXtT88oMG/n6bxv8Kdr7wG8EFAy4l1v4bTfzwe53y90/8MPfP1Xj1bymy/16iUP4lBlL8HFtK9hLtGPWi8N8D2pLu7lLDcvhp6Vj7/S8E+Lo" +
            "pSvx8Taz9fjRvA7BamvfRVab4UCoy/mTm9uqHmpL6o5Bo+cVCJPqoMvr9h8Hy+xBXyP2dPI70AuyU912R8vw8SNz7CBF0+YWZcPwgj4r9c2o+/rWQIOk1y4rvrsLA+ASfDvfVA4LsBSj8vP+UDa0Jw" +
            "r2s/8LcrP0sn9T39GZK8HQrOug9cODu9CFq8e/WhOggvmzmVZm24m3Z3uDJ4iDgUUa03LkPZt/7LXDjeDA89uYKmO+9u8LpojEe6sCYhu4Zncbo6V4E4OLKAuPLmQbifU6a4eAW7NxepADiFRNy8Qu" +
            "6wPLhYzDlZkRi7VAJLOx9Le7h41n+47cUeOXQxObiInZm3vlsTto/u7DZNdABBGeYfQRQ64r/BJZe+ECuRvUwbasCVFoE++7DQPRzaK70yLco9zDi0PMepyTtYvKY/r3RhvvMqCj5ij408RakzQDsb" +
            "ZL5e+Ro8fK+ZPcnVFr0oCj+9cPisP2Cadb9DePW/Xfk2vX1mQ0AuyJe/tJB3PC7yFL7pVps9tFnvPSB+Wb+oqbM/kRPzv8El/r395EO/K3wYwKqafrv8gO6++r9nPuBFtz5xAca+ehu+PobCKMAZLI" +
            "K9nbqJvi1Qib9nFSY74MBhvhdT1j2ufSA+ZMLBv5lUDL/ZQdg/N+stvYnDKz1LxIO/RFISPv64QT5I3Do/VmXNv0AhDb/dvdi7gByvOnZNCz7paqy8qnY6PQFgxTA/Wa9wQmFheD8yZTU/XF/WPdfn" +
            "abyq0oy64wY/O4MyVLxkro4613lFOaO5Z7gCKOC4iqsxOJjrpjcutRK4EhX8N2GkDT1FdZc7HKDtuj/7DboIpS+7IMZauoHMgjjOs9C4ALG8t0lOpbj8MdM3qCisN3yr4LzfoaY8RuqyOetvA7tpiE" +
            "07xKKEt8DJc7jSgw85ESMiuEFEm7csM9S1pqqtNlrI90AqCSdBqJDHv92yh74L3py8Y6ZywP17bj6bW8s9Ov4uvUGotT2u6nc8qzSbO44+oj9rTi++UQ8jPRprMDw3TUBADjbLvXRAFDzFozs95MzE" +
            "vKefqryF16I/is8/v+GjAsBll1W9OV4+QGNXl7+KmHU8gPcjvvVPuj1AkOg9xmghv1mkpT94sR/AVicBvpjZhr8JCwjALv/aOokj276lz2k+TjKUPh9yy71OF6E90AIxwMpjXr14F0G+sbKSvwp0pj" +
            "t5Eiu+qcWyPcS80D3OJcS/WDhUvweC1D/yCj+9nuY7Pbe8kL+3S/w96b4vPsssTT+assK/rf2XvqUzCrx9qYQ7iC4LPkwnljrpM4k9AcbdMj/qo2BCUh5XP0PHlD6tzBw+/UwgvcK0xrvdzIU7L/hI" +
            "vLIoCTsEMYc6XqvWuPCoBbgefO84/GWTOA8AjLfYV7M33RalPC4huTsrEJi6spUPu5ePirq0GE665hvZt0W2LLjZdIw2YqRIuOr967bvMHE4CpLIvEwWpDwtPIw6ZVyNu67JLDsUTSQ5VrLZuEIpgj" +
            "mgrwW4g7/Yt45/KLe8zzk3RYrjQPEcC0ED8EfADYBGv01AND7QUT3A8q3GPpRAKD7fsWS9hPuGPR9A/Twlqus8K2qdP5e5CL1fNIU87JK7PLuCREAQ9Am/BYJiPCyE8j0Jcm+9iI21vYWDsD9U29a+" +
            "hSR7v3+AbDvAizdA3xG5vVDaWTz6kBs9M/qIvLRx7rzsflG+fRbOvipZn7/jIVu90uxQP5NzLMA5DCy8YOl7vneKAT50GkU+CDT6vvGFiz8KBRHAUzq7vUG38D4jIGq/RKCTvD3v0L4S0Uo+ClKnPr" +
            "z2JMDIOM8/K8AUQK5FwLwZiek8qTmGv7shPz4HdL09hlo2QHsohMAfBwzA0n79vM3TZTwwXkc/gYG6vABUiT4Bvk84P1OPaUK3WmU/vmvSPqjPKj5btAO9btCUu2AwgDsF3Ey8twsAO2y+Wzr8z+W4" +
            "f43/tyECvzjXv3k4K8MXuNdy6zct09Y8tWTDOycxu7r3jMa6ELvXup5pgrq7TfA3bVDXuMoydLarTIS4oq0FNTLpOTiXVde88EfBPAoPWTp333a7z/Y7O3R+nji+krK4ZFV0OXEfCLiaYeu3e3Tith" +
            "qbGzfaXgtB10IbQSZkNcBmah+/qmy0Pf4aVsCCssI+zIUOPtoqer3BgJE962zZPIpwpjyr4KI/oFgyvsoLAz747MA8ryJAQPcAu75nwWE8Ns3ePTa7ZL3I1p69uZOyP55uO79FCY+/u9ysu2GHQUA+" +
            "ne6+fFhJPCdvj7sxY+w7TcaBO+JqMr4nTpA+uHHXv624n736ORA/NdAkwAKbW7ylQqW+8vMwPoHjfj45YLC+rGulP04jLsDSkbi9BbfTPfFlYr9lyWq8oHK3vnqlOj7akIw+1rwGwBjVBz8h2hBALj" +
            "gyvbrRPT1XvqS/jQVPPt+wRD6bZAhAaF8SwBW9B8BU9o47AGpYvNufjD8gXMS9WM5sPQH++Tg/zaJxQmnEcz+8G/4+IpQrPpyV27xVx1u765h4O2yOTLywDvE6adMfOsYrmri/Dh24m6l5OHHXbjiT" +
            "QU64aMdpNy9y7Tw3br479PHGug4XirraSwi77g6JumpAgzgABzi5gDj1Nud9i7iiDYY3xmXnNzwX3byeiMw8kMokOvyOWbtMQkM7JhesN6mxfLj8img5fmMGuB7As7f5raK2hZ/KNpanGEGMByVBf8" +
            "wlwGBa+77YWsw83HhnwB8Bwj7ONNQ9irhMvbwflT2376A8DKt/PHoHnT9llD6+cEpIPp/cqTxIhUdAv6sFvq6nLTwcG7M9pk5GvWBOYr0ZLqY/ky5Gv9Mwor8jkYG8SDlFQJhgGL/uty087Ac9vVjD" +
            "Bj0JjQg9iG42vd2nQT9uEhbA4+3CvbyKkz4QkRfAl0bIu77Ktr6UZ1Q+lfmBPq3yCr5yxKI/k45HwFf9rL0Tbe69kd1Uv96eirvYj5q+2fsqPgtcVz43G8q/LbHXvvPlGUAwSWi9UIRuPRuysr8kJT" +
            "c+fKBdPq3itj+79au/0L7cv48kNzxsXIq8YiFwPwJZdr3a5RQ9AVcAHj/8IVhC71RTPzCaDT6vw9Q9tMgyvbt5CrxfZ4o7BTAyvJ5HDDs1ros66RKtuMruYTcPWKo49AZrOEM7CLdoE442dhLNOwvD" +
            "lTvDwP04wUg5u4kdq7mXeM+5sfB/uLezDLkV70c4HvUIt66gVLeLhQk4XWexvOJ4NzxG1q86Yyecu5LuEju88tE5Uvi7uP3pizm6ara3Ri28t7+YAbdr4RU3TLd0QI2d7EAV81PAZJJuvx813D7ELx" +
            "rARLLMPqBBCj5VGTi90wgtPZnVwTwo2K48ekaJPy8nqz4KMzO+t1eDPHovX0BqFcS8i7tuPBf9oT3LEBK9Qwt4vfsLaz8wlpw+j54jv0V8YjuzaCZAkshKPyZbHjzcMu48oMRgvKqjrLwdx5Y+z+Pk" +
            "vuBfX7+xfxy97imPP+6TFcAAkz+8t1MkvvrNnz16RAY+C9q4PRNRlT/zOdG/JQqwvVppPj8vETi/jJ3svIi7tL5VpSE+tB+bPvYfQsDpJB5AmIwZQL/cJbyWdoQ8Goh/v5wb3D3F0ZK9BuIYQAM1ls" +
            "BaJsC/4heFvWLqED2uhOk98jUgPpivCT8B8gsoP7uqZkIhbmM/FV+FPoZv/j1YjiO9K9Hbu+kgjTsPizy8x9QUOxHkejpTpMC4O0KCN85fpDhaw444dw3wtxlFFTcVYnU8cSWvO9w+uLkaDBC78tl5" +
            "uqbiMbpVqZy3QYJLuc3QBDiJPea3AjCStqENCDjfesG83UuNPP57ijojFY+7Yo8lOypjljk3tpG4Bd+KOeRoyrfSN8233fUAt3EhBzfNOclAKscJQd+4T8AVGUm/oh+pPntOOsBTsto+Q7TkPabEV7" +
            "3UdlM9U568PD2brzwbZI8/FoAZPg3yYL0Zx5s8YSlSQImGBD51Mn88pvmwPS8rK71fAIG9B8+JPywKYL1X0j+/B78SO30ONkDFR/o+g9srPKzitzzf4Bq8sdGFvNkXpD507bq9/52Sv9u0Ur1GeIg/" +
            "aDMTwFC9eLxz5lG+ll7ZPe+MJT63JBI+1VCtP+uTD8Cgs7W92JwjPx0/S7/ytN28vCqvvjs6KT5wKI0+0wlKwOqTJkB6AAZAjAqRvK0DuDyygZq/s8zyPYWZc7wwmz1AkvyOwNF5yL+QXSq9VGu3PO" +
            "mMPj+ghWo9unO/PgH8oC8/hI1yQimIcz9ek7E+dUIQPvfLEL2Cc7C7yHaRO0Y+Qbyh7xc7hdhTOoelgrj23wU4tjc1OMuisjhey2G4fuPMtvx5qDyNrLo7K5Qfuihc3brXHMO6N69iup8ErTfPkoy5" +
            "qwAXOAsUOLjksKE2VeDMN+Miy7wXya48alZdOnvAgLsbeTI7QFFsOcZMU7hgfIk5P8TXt12iurf/OvO20wa2NpfzAkGZLxhBNfZEwOV9Kb/0/4w+F1dUwBUu5j4k2bI9GCFXvR3qdD1e1YI8Z+CtPL" +
            "JBjD9MdpA8kCdoPZ8LoDy+WFNAUYWvPksIcDx3wKA9FnoxvSY7V72qJYc/zj6ivn2vUb+A6pS67qY6QO42pD68YhQ8xh/HO0vIZbnHe4i7aU3SPs+sgT5d2cq/wRuEvRBYdj/sBg7AF/qEvEEPbb6a" +
            "bww+8K8wPnGdgz6XCLw/v8szwKMKt71mLPM+sp5Qv3HFubxO1Z2+bQMwPuspbD4nJzDAXhStP9LdHUCYLDu97u08PRLP0b+0VRY+RivRPeZGHUAysSjAI9r2v4qoQrsaFbi7YmqfP4eeorw7DDQ+AR" +
            "BoAT+QmFRCSj9aP5i5sT15pVk9Y5EsvWj+KbwSaoE7OPIfvKxaCzuXhoE6DrIouGkr4zh0/TY4kbQsOOe8a7d2LqY2eLNpu0OigDuxjcg6URhPu591ErfGGpW5muqAuPkEVbm0anQ4qWy4NoPfPreX" +
            "imc3KLKcvJg0yDtuaME6EZeeuzSZBjsRqh867m1+uF+Sjzl9Toa3NO+vt7+DuLZ1sr02tkgDQM5+zUCHUlPAhNyAv2gZJD/0TQrAsM3MPkTKtT0xbiW9TEQAPa1/bDybOWU88+1hPwhbBT++7qu+j0" +
            "xjPH/SZkC3H5E/t4WRPKm4bT2/hK28yS9DvS6O5z5xorA+2jAbvzKVWDtlpu8/lhfIP8ABADyd5bA8tUsgvIc1lbxeCSY/0Bwcvu7ACb828uO8WbbSP0A16b8w6WW8Zc3HvdsgKj3CVbQ9WUEBP5CB" +
            "tD/d3oq/tvmmvbePgj8hgBi/klFHvTC0j77LcdQ9xDmIPkwzdMAQXUhA9ndCQL+PQrwbMIc8SzOlv/DGMT1fqTC+mugaQBDwksA3d+2/0QGNvUwJ6Dyb5nc+QXdGPrrvFj8B5ykOP41HZ0K9rGg/17" +
            "lPPhqXmz31XCq9Cs4HvGmujTvyjy28ZekdO33JbTrIMxK4q0XaODZ3MjgReY44N4oDuMhTFzX4ML47x56hO0VWeDqhNzC7groRusdJC7qA3k64z36MuREsWDiyWka1TdKrttacfDfumau84CJQPIlZ" +
            "ljqiSJK7MEQXOwaz+jn0oj24wc+POUE7prfNzrm37VTktl9UqzYxnpRAcg71QALwVMB32lq/cWgNP4inKsArOeM+/dWUPZbFQ727DTE9vnBxPDEQnzxY0HE/v52mPoaxT74uDYY8zb1ZQHWigz9YMZ" +
            "Q8ziaEPfJh6Lzzoki9fygxP5DpCz5G1iy/ql+CO7TXFUDRoKM/GBAbPAySwDwbzy+8sDGbvDiWHj+Raby87aVKv5dCHb1UKrw/ypbzv88Hlry94ga+T+WEPVa/4j0Y9fU+jf+7P+Dy6r+/YbC97e19" +
            "P1IrKb8I8De9cr6SvrbrAj7MA34+MUR5wFzWekDLhg1AKd6Fu882PTz7mqS/FmUCPazFD76XwDpAgnChwOU3tb+b/IC9u5j8PC7jET9xqhQ+ORT9PgGFgho/Xgl3QhUaeT9VgZE+JXjNPVs0H71rXd" +
            "W7X6uWO94gN7wley47Bw5LOpC9grfKeB45lIPtthZN3TgLyHW4isUVuPlpUjyqvrA7rewPOmm6DrslopO6sqVIujZbGLhxWq+5cYB5OGB3gLeM2tm1Ir0xN/LctLzsAJI8h0BkOlN4hLttCSQ7yka9" +
            "OVH/17cxGZE5UgHEtxtzxrfyPQC3m7QENpb13kCFGApB9gBPwBlTMr+aX+c+ASFIwEx7+j4MmTs9a2hovUI0az1/k8U7+lfHPDgccT/bbjg+2ZCevcXCjDz8DVdA9TOMP4zxhjycr3o9kPcJvTKkLL" +
            "2bv0M/GRzOvbNzMr+QrWE7uVchQGx0hD/LXxM8SiKbPLIPH7zsKnO82TskP/bAHj7zWpG/2o9EvazPrD8BlfS/Xg+evM1gHL5XfLw9HcbzPbVSBT/evsE/Pl8gwN9btb3e3GM/AAY8vyu4Gb1i+4q+" +
            "O40bPk96Wz6hym/AjCtLQGQADkDlWd28G4DhPAtS4L/lWnI9ePp3vc1TM0ApX3DAk5TEv+Q+37y9+T08KzWTP12VhD0LYqg+";
    }
}
