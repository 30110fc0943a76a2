namespace Alate.Catalogue
{
    /// <summary>Trim table of the swallowtail, made by the command line: trim swallowtail --bake.</summary>
    internal static class SwallowtailTrims
    {
        public const string Text =
            "AQAAAL6Z74gFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+AUn8Wz+hL0NBiJtLP8Ehaz5d3609s/ODvnXD9bwLe3M8lHyDvUOOXDyw8487OmfkOUF1QDtLNWK5dKafuXQ1ZDaCAV45s0" +
            "zfPjzaDD3CSim9t0jVuxD1fbxf+9e6dRsRO4EP27pYr2e6gpiluRjZYTnzVbM2xpN0PUbWgT3sckG8G6d8O/yjMDsicY66FL9jOfvC2rmzeqS5DCwVNMasgTjhTNi1SW+cQOFFk8AqKxs/+S7tP7fs" +
            "hr7lHie/emIQvr12kr1ftIM5RZgRPmPhFLvjixG9UuSYP67XXD+8Li9AuAROPa59D0CkRoe/0172PPpFJj5zqKO+oDJevk+3nT+M/30/NcQQv7jYg7yxQRxA5KT1P3geUT0IY5i7ADsdPliSGj6Hrs" +
            "K/Mt3mv/BIE8FeOTW+iQSHPr/5DD/eVua7Fuz3vloVnD+Uamc/Z6IUvtb4xT6zxV0++32FO4hmrb9Qq19AgggIvBFt+rrkHyS9LSMTvQ6e174ef0A/RnqgP0Zaz7xgkf88uz+Mv1mdVT7upKw+Ip2G" +
            "v/KvPcA5I2Y/BrqTvRTAGT1MvkA+SIi+Pe1BfT4BmEdWP00VWkEipmo/uSgSPsXs1b7xCYu+Af/8usFzwTwFioW9RomDPG7Ip7p5gqu4fT5vO/9zpTni96y5QhCgORuNSzo0x6Q+neTMuyG7A70bAB" +
            "A8h0tEvKiIpzoXhh66rt1RuwIa/blCH9u48aelOAAfN7gG37i97XGuvUNgdLlRye47iOI5PDEUcroNp9a4dnxyOizE67nNMO04aJnQtxx4UrdUGevAjiD5QFzeoz8JPB89lxCBvrT1RsC6/bU+3BUm" +
            "PXZ7YT0ofWw+mmj4uw5IRjymc0Y/chHmP4SeEkA5UUU9q+wCQDOPAD9GDzU9GeY3PpCweb6k3yW+9g62P2s0cL/nUse/t7xLvWTfQEC2zry/vn68PH51/b1Lckk+X0GdPrJIZb559Z3AmhG1wE+6B7" +
            "6bSjq/T/Q5wNKlJL32/su+ue8fP1uyGT+UDxk/rw5UwNWjncAsq/+9Z7uGv2fTwj9Yt9K8mifFvh23ED8axhk/iurWv/s4dD8lYipAFpwGvU9WeD37p82/umunPl3AyD6hM3y/boJvwLbzdr8QA4+9" +
            "LtvhPJD2IT96KiS+IB+vPgE5f20/PdlkQR8KgT9WnRs+1NIDv+jNaL70UBA833ezPPKwi71fxHo8kVU7u6eyNLpR3GA7Q9VdODHohbk8w/Y5gb5DOmUZqT410r288G0FvZ5qoDwdelW8jt5AO4A5Q7" +
            "rPjKK7yjLmN6kOt7lVmKA4bDSBuKJ8Ab5eY9y9TtmtO1i2HzyFfV48bkyYugQjMLm6Dp86Bd4Rups07zi2btQ1wKvetgPhG8FPLjdBv2/nP/g5fL/5Ray+KJp7wD4d/j4Sy4o9zKF+Pa0snj77KgW8" +
            "oKQ7ulqlKz9k4+U/vL8BQCeDKT3rkABA+nECP+NEJT11Qyw+8KhevkiQ672/br0/WjeJvsCu474e3ba86FRLQGWj07/qTow8hFJRvWhldD1wyyE+swgZPhmhlMBGqo7AWpfPveYAVL9/sTvA2s0yva" +
            "/2oL4bVe4+JVXTPh5xlD/w7nTAd/SIwLXF3L0eBM6+Lgs9Pzmz6rxlZqm+IPTsPvY5+D6kcRLA2TKAP/KwLECEr+a8dhWBPcWF2b9hsKU+R6K7Pm1dmr/y6mjAm9h9v9lnaL3nvsA83P+RPmguTL4J" +
            "yLY+AAFaFC0/Dt1CQQ8jQz+jHR4+jrj6PXxAqb7H4Eu9Xv2APLMBab2QwVY8YbDKO3QBL7rO7KI66/shuWZCwTlCeOI333+yuJKomj7dWx09oGiqvK4mgLwdpSa8ToKBu9xfHjuzf3e5XGE7uYMmN7" +
            "p3Iuo16m6NON7ypT2ePnw9eAazu/xBHjtXIbA6GVTAusxLDDpYi1s5vxoWuduzXLkg9g849mC/ODi/l0CcjcfAVrbCPoHLWj/XELW+dLemvqVylj06FDq+iwK+vU1afz3tN2Q9qc2tvKVVRj+PdVw/" +
            "mhoLP+TS1zvQPwtAUDzWvVEoAD1+LT89E3mwvACyR7uf1Zc/r87APz3Bgj48CpC6o5s0QB67MD9ntWI9RJs+PV/Eej3j3309Y3uIPeLhFL4oVPg+psgUPDzh+j4l8Me/qdzkugSCxDwLWo29THlKvR" +
            "koejykJj2+mm5QwBQ8d70nkuQ9y75ZwGSWCD3rBgS+KLz9PlBCrz7frJK+yPh3Pw6d7z8YWsK8qPXDPKCuvL8P1ok+UmCfPvHGML93xjfAdNgDvlJGj700J4w8G1AEP+dk7z2Ylqo+AflZYT/jaVJB" +
            "EhxXPwh3Bz4PIh2+Eg6PvtLr4rwQM2g8CnaGvdfbhjzlPTM7S2szukw2CzvhJnA5/sWuOcedQ7kPkwU3obTCPh/1vDwDRca8/pbKuoDJjrytQaO60L5kOzRmFbvAT3a6AUNJukTJ2TnJbqI5LRotvC" +
            "16krxlCI+7ofxEO1Om6TuZhC664uwLOqpYNzlGJLS5Z9zUODDuoDjM1+A31iK+vyjtYD/CTwI/qww9P+dXM77Rwu+/zBuDPY5CSr4pyEY98lguPvaolTx6pUq99ptIP0NEbz+TiZ4/0C+sPHoFEkAa" +
            "MII+4a/bPOw6tD2U7hG+GTWgvXq+0z+vCdC/xZ2UwIWo072Vw+0/Izjrv0N/bT0PSH++XVg+P8xfJz/z2ZE90EQkwEh6m8BJUMm9xv8TwCgC878pk1Q8r6KIvkooND/z1gw/b85cPimKIj+dVM8+mD" +
            "zFO8zCsT0IqfM/VtvqOmW5VTxqT2699P/BvIKgbr/hj5s/EeITQOA72LwTuTg9jDC7v3+TnT6R7b0+49CGv5i7P8CCVji/trhLvZikijxIgmI+wJuovX/qij4AAQsTDT9QRT5BGHkrP82Zsb24ZOg9" +
            "usa8vlIPVr3S6z085iopvR7dMjxm9ts7H7B5uotyKznVcga4H1H0ORUMPLjDcFu40rsFPn++TzzAQy+8EuiwvBhaebs+al67PU6JOu977zmq+kO4K1gNurJTJLgmAU44uEK6PX6q+jxsJSM5bZ+GOk" +
            "4bhzrDuNS6uNPXOfmG8DnLpcK3Dq1puQpJ2LXfKas4AxoTQJ2b2sCIkyA+fkTCvMWgw767cni++4QZPtbECb70QsW9xw4kPLiBOj1TH2E66rrNPmh1fT+jtEU/iMYpPEi5EEAUwIQ/lq2OPMJdHz2k" +
            "7Jy9w0gmvZMXDT/nWcY/8ppjPwQyLjwEOylAt1vzP/h04jymY0E9pFaAvRlk4Lx8axI8m2o5vldXOz85Rlc8YetHP7GBSb+zS7e7wE2+PGqCBb6je669DM7GPlmK3L1GNkfAsopbvS6D4j9c4S/Ap9" +
            "uxPFW1o72SZgA/BxelPuOS0b5WCqg+FYgvQK5dAb306KI8B0wCwGainT4jmY4+bF+KvgcpD8CSHYi/06yHvWchFrnTl2c/CZnpPXOL1T4BQ9cuP3jVSEEePEc/5To1PVerjDwZncS+25JrvQzKVTxV" +
            "7229qvCBPLw+zjupIai6PIOeOqpZnLf0hBc6iQP0uJawPLno05A+BbS/PBUGjbwBEJm8r0UmvOiSgru+GT87JD/KuXgXpLm+FIS6bsfdOLineDkPS349julFPPucwbq2FFY6tjpvO7uDtLq6Dyc6LX" +
            "7KOTGOE7lErQ+5x7g5OCTdwTji7HU/KbCdwFv0BD5aeW8+KguzvsUrab8yfQc+72RcvizHa70a4I096Ll8Pe5X+rwLGBc/9yBcP3Kd3T4BlpA70z3kP1G6az9KZ9k8Zd4UPXZfvLy0jpc56libP9/m" +
            "nj+HfRm/X0eEvHJgRUAPOic/DHFbPen9HDytsCg+PGoaPnIFwz22Y5i8E/NYPtG4ejvyEwU/DFusv3Z6kTt/7Z88JGsYvbkY27wLaSU/m/vWvhw1SsDMZmi9vodOPnk+VsBgbeY8aWHuveIT+z6z07" +
            "s+qW0Ov/FLHj8tRS5AiaUBvYnL7jywmtq/WXWkPlymqD7AeDu/nC0UwFTuh7/rGES9GabHOw/C8D6FJMA8qVWqPgABWSbiPsBCPkE0mCg/xfQrvmlnZz0i3NW+BeFIve0zODy/kQ69lJ9GPL2ZzTsu" +
            "nY26C7ZqOUQ3EDcyHCM6znV/uKuN4LgAM4Y9HSezu+ZmM7ywAtu8kMghu05a8brxDoo6nOdGOaJiHLml/Qq615vDt/DObjiluro9hs5GvO0+hjr679m6gF8MOwk6iboLTtY5+qGxOSxr3re6+/y4k7" +
            "qiN/YHYjhTS2m/9STbwBDxgb5s+R++qmx8vrwLAb80i+I9o7oIvtEYVr1JZjs84WD1PIBiM7w2jSM+Xl5VP3G70z6S2JE7sErVPyZi8T/V0lg80fG2PBtHF717GkO8fZ2NPjAoqT9Q08I+XZIbO9yN" +
            "CkBhbSlAyZy5PIbX9DzEaw+8jy6BPDcC5byxe6m9H/UIP6F3GDw8iHQ/2oTFvjXqALvqq2Q8nd/IvTyskb1+t04/nKPNPbvPL8Djjz29HgoUQHwVEMCVI3A8Bwcovfsz3z5NJKM+FEoLvxlldr9wpk" +
            "FAKaY/vQ6agzy+3w7A5ZSwPlcYoz4WvpW+5/XIv+2Vxr+9Hj+9AggEvLuqbj9Sn3891+rJPgEr2Q0/K35IQVGcRT/HflO9N2KMvDNz7r4Xt2+9/YZvPOlLWr2PkpU8ELnPO1xM4roxALE6bm4ptvC+" +
            "XToAkxS5ZGiCuTcjTD5mWKo68a+HvBV82bxQEeW7+hAgu5mAJjtAbBq6U0O7uf//ZbowCAU5QmddOX8Lhz2eW7u8shU2uIPsgrrUYJc7OLiEug+aEjoEFMk53hkZubtkfLgtdFs4JOKZOGfN57/YF6" +
            "fAyCclvioR4jsqJIG+4UGTv2X5CD72M0e+5J3pvJ/9iD3ONzQ9hjb4vEFisj6P9FM/VDyfPs7HHDt9Psk/ELTIP0XNrzyB7Ok8dvyZvFYv/zuXT1Q/00ucP/sbvL4+GzW8XIgtQDrl6z9T1iA9C/qd" +
            "PCRz1D2L1AA+ASCPPAH0Cz12aKQ+3fS3O3i+YD+8DTG/LmHeOsqOnjxAR3u9z01Dve1Mgj9AXWy+M34ywNHgRr3k1a4/Qy9BwARdtTzuaJ29otzcPpDbvj5ij0a/MWLVvsdDRUD76CG9u07BPP3n+7" +
            "+iu6Q+4IurPjCfI78ps8i/Gbe6v13cEr0KCCO7RiEMP1O/YjyXSa4+AAFgZ6s+cpdDQcw2Nz//+yC+iT+2vJ2yAL9soSS9EmCCPBXsHL3NA4s8fkauOx7j3brLL5Y6cTcWOFSJZTrfn/64KZFpuYTj" +
            "Hz3muqK8OlNqvLhDBb3epru6erDkuUvkxToTaPC5OUW3uUQO7rkCgaw4xRc2OPmenT1/G1e9ndsiOpv9JLvUsos7XWRDutbF1jnbJ6w55LSFuEYayrdTqhM4JCIDOP/RgcDNOL7AuIDKvhd+x726mD" +
            "m+xMCEv0jv4j1Dpg6+InkvvLkK8zxUx5s8fs6hvIF6tT1gf0E/U19LPqdKbDpk5oc/wdcMQFguezyk5qU8u/Q+vDyHYTy/SJU+kX+bPz2XjL3/lKW7G3XYP1W1PUAYHuA8SSXlPEduLT2g/Z09r7KK" +
            "vaT/9rvtGsI+qUrTO0uUaz+l/KG91YayupWzKjzEfpG9OIt0vTqSkD/DBHY+Q4kXwGGlJb2ydyZABrcCwPZklTwCJty85N+9PisGsT5N7mC/GUf6v4fnOkCZwVu9W9g5POftCcCTDK4+GMGzPme+/r" +
            "78X02/eP/Qv3SO27zDBCG8uqUwP93uJTw/p6I+AYlh3j41Tk1BBjNPP9BUgb3Cl7q9Mh0Jv/wHOr2sy5k8329lvc69uzznYpo7f6Uju551JDsHm8k3OhyfOmJUmrnRm925UTAfPu1PlLxjdJa8U8T1" +
            "vOA8q7s18yG6RbksO6iVy7pmgwu6eK04uvmBhDlg8V85HNE0Pab8fb21SR06AQtxuq8V4Ds+Sle6uOP6OWsC0TmplU+5ahB3OEFvXzgrIv83C/egwM4gZcDy5Bu+SbzNveJAWL4KaOC/O+QTPtbULr" +
            "6er+A8gIvAPdBylTxIrwi9Z915Pu3oQT8HFEY+mXb1OcQioD8VG/E/wOefPHva1TyI5my8ErW3PES5UD+5dYo/V2kMvwQbabxhnxxANQ8QQArQDj1KSIw8h+ndPa6ILD6Ct488vXE8PQ9+KT48lj47" +
            "1up4P3BI475mm+46ieBMPLspIb37d/e8tVyoP+wi973CGRbACB0rvWDd2D/j4jXAUnatPE75Qr1bA7M+Mum+PhrNl7/ztpu/SvNLQOSuNr0fgp48MKAEwHcypD6BErA+dVcwv60vZr9Gh8u/uWXFvE" +
            "s837sWBNE+2uwQvLKjnD4=";
    }
}
