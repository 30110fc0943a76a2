namespace Alate.Catalogue
{
    /// <summary>Trim table of the fishfly, made by the command line: trim fishfly --bake.</summary>
    internal static class FishflyTrims
    {
        public const string Text =
            "AQAAAHxPhA8FAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+ARCyFD/p6Z5BH+1tP9qseD8wV0G9OHIFvHAZhjmhJz08HscvvSdCxjrksOu508fFuiiWBDrwnne5HAxpOSv8o7jVJFw6/f" +
            "BLPjtZED26LbS7bxMmOnmxILz8GA+8WK+Kt1WAIbqLJNK6fRxAOTjMizkJQC04A5aqvSES/7s/hLQ5bwVyODAMODzK3EM7iUc8uKm4SDl1sAC6G2mDubIZnzfTEvC3zwt2v+grJ0HQqbS8glaSvbEo" +
            "nD8Ib5DAZWT/PX8cKD1siVW+rTWoPiUGL73vu988H1tbP16ytD72OVg/lXUDPaI23j/lhqM+PvoavGgW5D14Kaa9j9j2vTyxvj8UGxm/TLmxvwVAor2sMyxAwRygv6aJpD2eY1G+JHPGPY1DxT7xVA" +
            "y/DEb0v3vMNMCkWx++gunRvzeYDMCG29c9QWXwvkT8mj7dqjk/J/OPPp3F1763j7i/rqQEveT8tT6YY6S/DHzQPLcgj73kdPI8ghC6PZQ0kL8v4Zu9mDCxP+LBIr3vBm89Ht5Gv22GqL0zxKo+KicS" +
            "v6mqKsCkWTU/5CTPvPRCdjz8BQW/9wGAvZCD0TwBFqYTP10ToEF4e3k/9BV5P3Pgr70zVwC8Ucc9Onl1OzyudC69RaPFOju8LbqrG7+6sgCQOQhyFbkXM4I5umnyN/RqRDpyzEU+qCwCPf45rbs3L+" +
            "E5zZQ0vB9PArwLOMa385UHui2S5LpyGrU4vuSUOcMsDDhY3LC9X6jVvN4prDn6bx0478Q/PKpcZjvh6h+4tzd1OYNa1rlo91q5DXsyuMKQD7joVFPAqAQvQd3tSzyVfqu91kq2P0dxl8CNQgY+iy/j" +
            "PMaIL75geaQ+GL89vTbOHD2sjY4/xDYoP2wEhD+BCTE91bUBQEc/ND/saae8lKgXPqwHwL1/AhK+mwTHP+FIWr9s+Km/a2Knvfr+IkC0qo+/orXRPaiFXr6eA6I97QSzPnsJKL88ryvAPYIzwOxlJL" +
            "5de76//VX6v4qwHT7rlvi+5w+HPrUlJj9Abcw+sSAUv7Z2yL96bxS9RWjgPnUCx78qKHg8JpWfvaaz+DxI+bA9QuDEv0dVgr68zq8/ap0rvVwybD0FSHC/DYz5PEdllD7QfsO+1CYuwOQnAz9Cstm8" +
            "SoJqPBOV875g6M29+PpePQEC4hQ/WZufQSyvgD+Ktnk/kWOovUXUyLsYKaw6MKE6PKe7LL3n2cU64d1QuqbexLp1pyE5PWwfuYqUkDlZ4vI4Dpg8OhxDQz7PPfQ8bD+1u5HGLjoLdT68EBz4uxEkDT" +
            "ceeSu6deOsuksc/ThndKE5S0WHOGL6u72RIa+8ijXEOcKRfzkZ10c8DhhYO8KDjDYf/3Y5r563uamfSrkGJXI3qx4MuApzLMCcoTlByZOKPcj0nr2br6o/HpqcwFBaCj6IOgw9fHMcvvEeoj7KSCq9" +
            "gZ0TPVk2lT8LJTI/Vvd5Px4eOD3iBwtAXmBMPxeEx7yUKhg+QBGwvQ0lC74WXsI/ZXlTv996nb98xJ69EnQqQGGthL+i6c49AvZEvmTVgz2+w5s+oAYsv3QTM8DvjC7Au7ElvpbYjL9ylhLA8ZwgPv" +
            "pD774h73M+U14XP/ND7z71mNy+nHGyv8wu0LxdHOw+exbDv6OaaDzC/Ci9PPgMPMm3GT1dEd2/wnKuvjxQrD/qlSe9gWZrPXuIi79HMWg8uEmhPjCp5r4t2jHAyLnGPljP4Lw6z288ah/Cvr5nBr6y" +
            "jJM9AUzoOz95KpJBJWhUP8wCmj7ztTI+tuwFvmF8pLzklEg8iTArvV9m6Ds+j2o70P+zuQgbUjoDozc6IZ8uOdPR+TdmpWA54wbzPdY+sjxQlZu7Da8KvDjNwbsXJVW75T6zODOAtjpKrsK5brfGuY" +
            "5pOblof4M58t6rvSWBBj6CuIY7+JRTvPmZGzwiozi6cajOufUobTo0KJC5Hw13uBxoeLiIzjM4LMByQZIfG0FVhULAQIF4v/fMg76KwV3Ap+3rPosSSz4Kdx69IjNCPju4Cz12j1c9sTx4P7ZRJr5R" +
            "Zgg/mLzQPEXlD0DM9ny/Gg/gu5wB9j1BnKa9FEhOvgAR3T+tRKi/7FmPv2Fvgzu7HyVAeQ+SPsq7qDwvsbo913hevWIpRb6PcZa9mhBTv0a3975LPde7Yk49P21VJ8DQBY87bQSvvI7vyTxIqIA8RG" +
            "FvvwoTiT/CNcu/KDiWvS63pj7GycG/KJUmPfS2lr5brD0+SvkOP6+CCb8Q/fM/VMvcP2nsybyBZxg96KuTv60KSj4oHL0+fcCrvVQnaMC7HMo+g5CQvea+QD30bxo/01qmPV5hvj4B2ZFDP+TKlUFl" +
            "6mU/xAr+PufUfj6l+bC9fvFAvMKDMTzQnTm9KUq8OyT1JDsGit+5ss7xOqPNljnoiA83R1e9t1wJmDlEFRQ+Xvi5PB5uwbvksJe7OHYDvAuDibsxL2c5ehz0OfbgubkEDEC5MsGTOJ9lajgqxbm9ui" +
            "c1PowlBTvFdCu8UT8uPNtu47rsDMS4tqtHOoaOyLmQFMC2b1+lt8YfEjiJo6dBIPArQVv5IcBtn/u+P8ImvxMRgMDE9s0+Y2JIPdgnurtTnIs++cYKPRp2qDw17YQ/1qcivzuEgz+j4xw9nRz6P/ZD" +
            "M79n55i86C0QPnSBw71iU3q+z1LmPxSEcsCzArC/8vV7PJGrG0Cv4xe/oKcDPfZ6+j2JwAq9P2WIvl67p76BcDg+MiC9v0n1Rr19utI+tWlTwDQiIj39CBy+PBr7PaMqmz53/nO/mtoXQArNBsDEeK" +
            "69tjrXvm/wqr9jYmE9WBCQvoRVMj4XfQ0/ONMovqe9oj/ihfg/BpAXvUgZXj3pMl+/DhdFPk34yz6eR6y+WPJpwMToyT78vTe9dsr/PNksjj7vIZ29sTY1PgEs8zY/W7KdQWJ7cD+kviM/2OeWPsxH" +
            "gr3kOAa8PnA/PMJmOL0MUpc7nRr2OlWySrrH1/w6P3bBN8n1Urh2Lfk4dHs8Of5TGj7V5b48x7vGuzWNSbvAlvW7Rhaku5AcPDmPs025Q5GNuenlkTn/6bo4USuFOLLDrb3HZUc+zONLOrd0DLxmFi" +
            "88vEPBukO08Dhwahs60/nfuU6VerfPsAm4DBh+NxVhwkFfcilBvTwMwPosTr5hoRW/eFuIwBmXqj4ZSnu90ddpvPBmpj7R7qg8wmwIPdJJgj8Yh6a/afUeQI0ujD0jJg9Adg90v2dZqb2Y0EI+qiYe" +
            "vjrlsb4jjtg/M93JwJvo6L+YAJQ8jZwAQKfpqr/h946868zjPZrKwTxRBI2+5/7Evixb6j/s7obAdJHpvas7gr3CX0jAvnUhPhPHk77en4M+QucUP5JrXL/GYl1ASQZJwCZby716wYu/Z64qv+Y95z" +
            "3pTIq+QaQ+Pib3CD/pAse9tVZiP8JbDkAkfSe90HZoPSVwW79v1U0+++K4PiJpRb4gQGvAtsTfvVnQ87zF4Hk8EqqkPtcJ373qA7g9ARsBHD8OzYVBCOxAP7VCBT1rycA9+8omvjnl3bz2kTQ8B2kC" +
            "ve9atzsAtxI7JLYyOW/MB7o/Ufg5/yczOOARFDl0jkG44rwnPRGjRTxCJv65twIrvPXBrrp04hq6DB+oubjsRDp+ew05S8PmuAWgmbh8Xxk5xJ2QvU5lgz2QQrs7mZSDvJDJ5jt2zO058qx5udQGKT" +
            "qBk6y42l4sOOWJCbh1JVQ4VOLYQLal7kCntVzARPicv8zQGj4lIRXAd0mXPkKq3T0SPME8XdtHPZj3Kz3LvN08hJlTP8UAWj7z97G8o2IjPNU6L0A+wh6/KBudPMePqz2eQE69CVyIvMa6jz+El/M+" +
            "8NUHv0kQdbuKVTVA/WiKPo4qvzyoKxw9hazovIBz1z0KQhm9Iohmv2EBHr+EDF+8nsYPP5RJDMDpWp276ZyIvSY6Xj1N6LE8KrtovmqVBj/GdZe/g3WIvcRdAD/JW2W/ogTFvGU6sL5UV0w+wT7gPs" +
            "sXjb+s+NI/lAEhQGe0PLwCyLQ8wGLjv3dSTT7Acn0+d5qXPhNlLsCszyi/wdmvvTl/GD3prUQ/Q7EnPjaAGT8BnRU3P9S7kEGhX1k/yp0yPlDyFD4AQhe+RY/CvOYhWjykhRy9OqXiOyThUTtEDsq5" +
            "zkoIOucZFTqdX502AecGOQMZDjkEjbQ9e4uaPKK/Mbu/6iK8S3dsu+NZAbswU7G4INA2OhS0FrmzIi651LaWuMCYDjmkBqa9XsbgPdT/nzslF3S87fwUPJEoaDkZilC5ISJkOgPFYbm9w3+3kwoiuH" +
            "SyMjgK20hBiWAUQTJBXsDx25G/AcmgPS1RUsBERuI+0eLMPcCmObyptBU+0zwcPWr+CT2xP2M/kZbvPGnPkD75L5Y8WRMRQDfzuL7k0he7j3S7PejOb70GR869dKvIP7XGor5FrGG/VDs5u888Q0DO" +
            "0yu91/m7PIyZQT2rQZ288TlmvAI4T73fCKC+eewgvyB8s7xOwUc/87oNwF7rizyOUqe9qwWJPTT06j0fBuG+AeegP9lz0b/KBqC9Jk5wPvo8f7+682096DqVviSIPT5Uy/s+bkdZv9yc5T+V4xtAXj" +
            "TMvMkmFz0IELi/urhcPn/fnj6jOoQ+Wy9bwMh7s74kl4y9LSgkPUvcHT9FqO48+HXUPgFt70Q/qD6XQctNaz/+Q5A+U3I7Pse8AL6tvqW8WTx1PPDdKr28ddc7CtFjOxOUZLoB1pI6CFG2OcFEP7n8" +
            "zE05hlZDOVZJ7T01Bbk8d+Z9uw9GD7zzapi7npFPu1ArDzj2CBA5ZT+QuVpgMjeSQhc3Rc/aOIEPrb124BI+2Xh/O66SWLwPnys8LaCAOcMCl7gDfGU6SPOiuQB1brhvxRS4yolxN5RBiUGAsyFBaH" +
            "lOwDcIdL8zsMI90M5+wOMI8D6kKxM9hx0mvT/TYj4PUWc85nj9PPP9Yj/2HJW+R+gJP5IzujwgLwtAcgUcvmkeGLxn8dI9dxl2vSSPAr5BQdU/6vavv3dFkr+xCQ27JB5BQEOX0L5XnNY83GdJPZ4I" +
            "OTvvZY29ScoFvD4IrD5rH62/C+0svbrBQz+69g3AYDApPS74G76/quA94DpxPtbpx77RSAhAyngOwFrWqb3KEu28Gvtfv2WdmD16OZi+kOw0Pk+S/D5SkVS/NSGzP89/I0D2HQ69D5JAPSYCpb8IAm" +
            "I+Qge2PnJyqT7Tol3An/LWvgIuSb0NYPk8M+QWPyYY77xdGZE+ATDo8j4YhIRBVngnPy2bzb3PoA49Gq4Uvnmv9LwwY/g7INqovAAqVTt9zEc62h5OOcKyjbklZCU5ec2nt4MJmziKcoq4JKkJuxDS" +
            "4zsZKsY6kvoovE2mGrlg9Bu5dunouHG4YzhBUuU4PGgBuH2hlrfkUJU4jiwjvVeetjzm4Lo7wx9KvPtIhztf9Cs6uvZvN+8AkTlN5oi3YFD1N3dDhrfuZXY38EoVQHRjhUCt3ifA7TCbv+z9XD4gQa" +
            "2/b9UBPkgR0bv//JY8uUwfPM9PRTz9GEg8D838Pp3n8D7UovO9zKJgO3AdL0DyFwY+cM88PG5bIz2N3ry8elXsvHmXJD9vRUY/p3Ozvv4svrvAp0tAWmxbP5s2ODyTPhw8VX5ZvNCrEz0+S6U+GEc8" +
            "v0a+D7/E9Uy8dGB4P0eVB8Adch67m+xFvbCYKD2OaRs7J96RPu40PT8KBRS/D95rvf13Gj9heia/D8vNvDswiL6uvAU+y6jbPkjOor+4wgc/IDVWQE8K1bzLJ7I8yhIMwFefcD6VYmo+MjyWPvMJD8" +
            "DYJpu/zQGivcANiTxiMUA/rWIDPsfqEj8B6voVPxuzjEG1ek8/l0UrPRmNrT1ACSe+a50AvUcIUzzucPq8R3O5Oz1aHjuKfwO5plEwOUilwjkag/C3thInOXs9CjicVSc9F95sPIHuKzpm41C8Cp+s" +
            "us8BNro2gCK5DJqGOO2BRDjfks24AxwOuHdAAjmrWoG9U8aQPer0xjs1WX28bD70O7y+hjqqgdu2YK0rOmISx7hIzdg3wzv7t/QC2Tf5bPtAl6DgQJDYX8B/0q+/QRO4Ps/OJsCSfaM+5L9kOzagjD" +
            "ymqn09hwS5PEdr0TyEdy8/Ejl5Pqvan736rgo8QWMbQHNHhD79bTs86ylwPdil67xGGRa90EmFP51uuD6A/ya/MaqVu8owSECWplo/OKiSPEwWujzjxwG8YQOcPBZUgz4/0Ky+avQDvx+bgLytG4s/" +
            "U2n1v2DSKTuBL3S9IIU8PV+CTz0bqEE9scOQP9e8ib8kaoW9yn3xPvLXML9keQo7CfKGvl/gDT56KMc+1Ammvy0vhz/ZfVFANunfvPDw8DxVDPS/8z04Pmq/gT7Gdbk++b0swKWtlL9XmYy90VDKPM" +
            "rOSj+j/489GZr6PgEoLig/C+eVQQPHaD/Pphs+lbrrPagbIL52HvO81BeHPEImFb1hKNI7kR2AO5FAU7qBkQs6YHjwOTuXSLl1qkw5rk1rOXm0mz1R/qQ8G+aDunbSULxo0gy7Wlbiuiy+8rh3+2C5" +
            "koxuuaad/bjVZsY3eGzaOCXAkb0GidQ9ksGqO/DAd7xzzBs81NW3OkhEQ7jwMmA621osuQvoj7joilS3KKkjNjDjREG56AZBNUxqwIyeob922gU/EV1lwHZi5z5wo808y09WvZhg/j2uyU47RlNbPB" +
            "dCMz8Kna89PjBzPqQYcjzNFxVAtnO0PgMKBbxlIZk9bf8QvSHxer3q0aE/smO8vtahYb+Bemq7XTlOQA9vCz9OX0c8l+3mPLotqDvYI7y8djB5Pkb7qz3FFWG/gonnvKq4hz+8OOy/s0wPPS0Z0b3+" +
            "sIE9rf7uPeWJ9bwcoNc/4tzav2AolL32GHo+xkIvvw8Roj06D4e+qoYAPjkEwT5BcZW/xkydPziFU0CiJgW9WdAZPbvs6b9sLh8+xQ+TPu9l4D6/BD/AWweMv9kOZL0BLNg83kRVP2I4Hz00HMs+AR" +
            "/Svj7pj4RBHa4pP2JLCr6Js1y7nrQPvsG0EL2c0+w7U8yJvKlmQztCQhk6akccOfWuqTjz6gg5IoNSNpQ6Dzh57oS4hZCfvBM7ojvW2CM7KvA9vF6L8bZoUgi5HhTONqnLJ7m4AOw39qZUuGYlq7b1" +
            "ikw4qsq1vL8dCjxIAs47fHlAvLEVfDvPdmw6vMC2OIqNZjnXR1625FKzNyBNirYbVJY2ur5hPyKtFEDD8R/ARxyrv2utlz5Uc6G/51LOPXmVIr28/Fo8DpTBOmQvaDtjBBs71am1PvrbAT8s0HO+qc" +
            "UEOtLIHUAZpIQ/vkYFPNJ6xDwnHQ28YAzfvDog1z674Tc/wWisvp76n7ti9jVAQ+rtP9RE5juy1+w7hHcBvMwxUTyhrAg/mYGovsct/b4AUTS8aCrfPyn2z7+e99q6wWABvd8ExDz9UjK8AwYKP/6X" +
            "gD+LYzC+D+FWvYxgPD+84AK/hAzWvKCjXb7/Rl490nC7PuK5vL8Pake/MWN7QIrrQL1Bk7Y8pvQcwDCOfj78Qk4+kxCRPhefzb/XweK/iYF0vUQqSTstAn8/9XWzPd2f+z4BTCLnPsp9jEGukFI/8n" +
            "uXPIDXJT112Sm+/igcvRloVTz8Bde8F8igOznUFDtpWiC558+cOYCopDlf+8o2kqatOCctxjXoEGg808ZIPHj5NDu5YHa8xSa/uYNWRrnop9e4Nrm8ucJJubc2Kh65Aw4QOOzD8zh2Qzy9s/lUPcqC" +
            "2Du5GX2828TkO3NJ2DqRR0A47OYTOiCvBrg9ARU2sdITtzAAejcXqLhAJj2jQJVCX8B7Db+/hoQTP2kTHMC+CYw+8yK7vL+JBzq5vrA8lVZUPLFjCjyrygM/u7fNPmKLJL53zpE7x5AZQHk1hT+Grx" +
            "o8L3knPc8DSLz66gW962NAP+ub0z4tXxi/JE+5u/SSM0Cux9c/i1kkPG8ZLTyhQqC6NvoovOvU6j6TWgW+nHYCv/JfdLx2acY/1QLJv47aHTuPWl29a43/PFEKBj1qaow+U/qhP5yvOb8HS2293WUQ" +
            "P/51Bb9Uo5G7ZyJ2vv3nkj3b07M+yZPDv0c4JD07KHZAmyoZvdiy5jz9CAzAz9AzPhb2VD6QssM+nsoHwEIT2r8cfXi98hFIPBDtaj86oG49OA7dPgG70Ac/nPCWQVlhbj96c/Y9+xCNPc2lLL5vPR" +
            "q97KuSPOKDBb0/+7k74z+OO6rKdLqNelM5+nEaOunEQrm4zCY5MryiOUMZRz2KFZk8hWvOOh9sgbwfp0q6+Axbup2IQ7lrsiu69XVTuXWdgrkv/Zw4X0PROBswa72/Tqw94be3O7jegLyTcBc8n1QN" +
            "O2CyFriB5lY630WyuCtmtrhpzCc3ZrHntUejIEGLYNtA9jV1wJKXrr8+rFE/xGlgwNVy4D7qcJA8VaeHvWgCbT0l2ZC70S6YuwPCCz81SaY+hIqCPRjeDTw8BBZAssmDP7l1wrq0T0o9bHajvIbg3r" +
            "xyt3c/rYIVu7PtOL8TQWO7hdU/QCE6sD8fSfQ7xtKXPDea+jogQLS8Bt3aPq7oPT1EfzC/1CGnvOI7sz8IHcS/cXnCPCm7jL00kSo9Hm5tPVq2Pj4ySL4/yPayv39qhL2VtM4+mEIZv1pUgz1EpGu+" +
            "1fW1Pfbjkz6KYKu/FX2wPkW5cUA+7hu9eAkPPVK6AsD37Oo9JXBfPs3+2D5RbBPAn4/PvyO8T73cc2o8WVFwPxJWwT1pFNE+";
    }
}
