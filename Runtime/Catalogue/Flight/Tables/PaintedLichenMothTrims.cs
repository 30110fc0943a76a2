namespace Alate.Catalogue
{
    /// <summary>Trim table of the painted lichen moth, made by the command line: trim painted-lichen-moth --bake.</summary>
    internal static class PaintedLichenMothTrims
    {
        public const string Text =
            "AQAAACBxA9wFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+AUqXRD98tRZCOD1sPx4mdT29Zaq+tZmyvasIQLyGtQ88a3iavClFozsRV/k6SfhFuqboCjr2kng5FYpSubf4Arcb2sA4Tk" +
            "dePcWUyTvBRs270aMSu0aI4roWHu03VG2QOVBdl7lsxyW5+QjMNy+FQzgcoLw44+T6vE68LL3msVG7YmB2u4IlyjskSBo5hXhtubSjYjqhiVu5d6dRuLoJIjiR0423LNMgwaue6UAFT+q/C2THPw1G" +
            "4z0+dpXA0thrP89Adj4AvpG9ChSaPqG2Ar2nLpa91XxHP9iw0D4V6dI+leTAOnLdOkCRFRC/PUscPBQdPzz5RC686HRTPOd1tj9fxEy/HpZ2vh766Lxe6OM/djBtvDDNAr3LOpm+nOqAPoL7iD4CDJ" +
            "k+dF8uwPqrKb8+9qe8Ye3Rv47xq7+CaNO8tOxVvouXSj61cDM+lbY7P8HY4L++pCPA/HQ5vWBIFL92VYG/y21OvanOwL4ZUaI+m2qyPrSnD8ACLJA/CfgJQFm7crzCWKc8djJgvw4Hwz5mNr4+N5gk" +
            "voqZZcBf5Je/NVgAvWPvRTzijhY/7EWUvVvqiT4BDLODPyAQJEIubok/7ftKPOuJ474erJe9Nxuwu0RG1jur2Zu8OoGoO5aUgTqf2UC696rmObl1nDnb3oa5D0CPN+MRKTnT+Zo9+XkCO/GfDbxxdz" +
            "w6dVRVu2nAIzpMlQY6yHGFutGzobkh3Sw5llD6ONcweDjdZVu904S7vb1fx7qfQwy7RYcCPAQHzDmR6oi50MWDOi5tNbl6OEY4siJuOK6KGrh1V77BDrNeQRAckr+MfU8/qoemPqkl1cA+ipk/gu2e" +
            "Pmmpoj1sspE+zyapvdOFAL5rFHQ/GIP1Pt/jFz80loE7dx4gQFpgrL4uc4484B8wPXfpAL3zVhw86WPnP1wr4b/g1+o9ZBmxvCOJ4z8p1Sq/xEoxvYAwkr6wxoI+ZvBZPo+6NT8M2H3AXG41vxXVoL" +
            "z5ZAXAT12Vv7NoEr1I5mi+xEBmPkkLID7iPcY/kMckwNDsG8DvDDK95zCPvhv4db+TJJu93JDqvtHxuD6XYIQ+DlVSwJvskj5f2sk/vql8vFyZ3zwWrVO/i+alPoe/uj4meiO/Dc1MwE+TH7/fdpq8" +
            "7YZDPANaXT3K1QS+kvxRPgEBP6k/HSwpQl+8kj+ONQi+QtznvgPqeL1Il4673W6vO9vWmLzeq5471xOCOs2MVboOVMQ4PdmpOc2XiLlyyX04YjAbOTPLtT2pYeM5eewdvGMq9zp8LpW74UKHOgwPXD" +
            "rZvLm6BkHhubdJbjlOPCY5ZxyjOJ+Kgb0P+Nq9eT8DuiTDlLo2yBM8d0peOkkvn7nj1n86W8AHueHNtDjiw5k4uUwAuKAv5cHgkodBEtYfv1aDjD7vOjs/QMX4wCe2mT8Nor8+9H0VPhcYYD7xYJa9" +
            "+JsvvoBMcT8ldSY/hT4EPzmTpzvrAShAjRcKviLuxTzeQo49s4trvfnaXDnf2AhAbrFGwMmRCj8GObG8pA+uP/CfgL9t4oO9LdS0vlgmqz4yGz4+VcG4P8PCncDwtf++ko6FvKZIAMD6xam/LsXFvA" +
            "dnSr6L92M+i478PbSr/z9S0TnA3tkCwIoPHL2VtbU9ROLBv8getb3rOeq+OqO9PvzoMT4cXH3APhwgPoQ1aT8GVB28fGLKPEQ9cb9AvIA+2V23PvGKoL/qazLACtiOvpw9UrxHOU08C6F2vo3et715" +
            "8G8+AbygIT9N6wdClxlTPyCcIbwkuGa+aDmyvamMhbxapQc8FA2UvO56jju7Eh87Y18ruiunoznq6uE4YSccuBcMJLhxHu23fA+9PG7fxDsYzga7c3N2u1LB4rnR0CQ4ZYCYODgEh7ZqXNS3+XEPuF" +
            "UFOrZ395U4y2p/vMP0fzvLZHO7aV7RuzwrnTuvwjO58WI0uZKpXDrGqyK51D7cuGqVojdyx+42frlWP+U9VkCmtDLAA8PPP6jt7L3KYk/AwvVKP4v7JT4ceAa+V/NGPukGQDxnwAC9d8ciP8OwIj+c" +
            "vcI+bA8iO/IlSkDoyqG+XA0HPKh+oDyh9UK8yGzyO0tObj8NhAw/xArkPlb7lbxNtw5AhCHIPofJ4Lr0cyK+hoRFPjQ5jT6GdVe7lzrDv6iRtL27+dm7uCtRv4nO5L+144m72P6HvYzrsj3OBoA96m" +
            "axPsQqjb85btq/nsIwvQMWML/wSo6/0QtyvEM7mL5awJ4+JLvdPvSMD8A/ndY/O3QWQDDQOrsZtTE8orWOvzjBaz5f0UE+770CP1ZJQcAhb5e/uztHvQIIgzw1qRU/eZWGPpkADD8BYEJYP6FwGUKI" +
            "A3M/ZnZrPHnMob6cKam9++U3vFVM9DtWcp28JGSpO05NBjuPgFi6GLPhOd/wPjk3Wvm42NMUuPG7ijdl/VY962DPO8wvl7tfXuK6M6oQu+CaDbnyPwI6ijLluSUePblRO983DMGQOJYVnTjsRQG9rT" +
            "IPvS0tJ7uQKqK7V3HMO8oFtTnWEB+5NoFjOlz/ObkQU064BAdCOPE6TbdHvgfB1xb1QKr3HMAF06E/S0iIPhnkmcA//XA/ApIoPiZmk71Y24Q+hJ3DvMlouL2Xa2g/E2P7PtX+7z4LbcM6vGYoQDB0" +
            "dr7bhTc8czFdPHMmNrtQcsk8QfTbP1SoRL9Qkuk+KA/UvMY71D92v0i++0y5vHfkir65wos+jaC0PhLO8D6wXxbAmDgGPP+HIrzHCPm/Bfiqv1vi3Ls3adq9O+8HPp1PAT4C13g/PjLFv4ge8r/Rzi" +
            "O9BDjXvsyRvL8UMRu95QCpvmZSkT43K7E+Ek0lwKskmT82XNE/CraCvFQ6sTzcXWS/W6OUPtkLqj6D3p28gnFFwCAfkr+Rpce8QmcuPCKeoz54xp68Q8eNPgGY+oo/FH8iQpoBhj9oApe9kke8vkOw" +
            "mL0r0QO85vPKOwNjobwET7A7jsPJOhwiX7oG2co5vCFyOTToTbmLOAi3oR44OF13jz2I+ZQ70MbHu828Ajn70WS7o2xROZRCTjoG13a6PCymuRQqpTiiehA5OlezOH/OLb15I4G9B7mXulTJc7sckv" +
            "E7tVAaOip6GrmfXmY6j+EhubcY3zewsIY4voPht1rUgcH7vS5B0HP7v/d4HD9cffk+M1bDwIjZhD/dDjI+aygxPVe8gD5cSXm9pNoSvlCwhT/2B9A+W0TlPqToHjvZ8SVAypAPvaIThjyH0uE8R716" +
            "vJSaYTzaVRlAqxL8v8x/Xj9Yobq8OnivPxsaF791yea8qX+jvoDIoT6fHJ0+RTufPxKiRMDu7oi8zBEFvLltBMBhUse/uM2BO8Y8ur3xxgM+aa3TPRvlzz95Gdu/YYrfvzP2DL3vkp+8xhjjv6lRPL" +
            "0vVa2+VdaMPrADfj4/n07ADD9uP+UQgj9qjzy8grioPDYEbr+etZ4+k7mlPsEUAr/sESfATj5avxvZZbwVGwE8hSIhPZQGa71qL1o+AaFtCT92kwRC/KkvP5vnFr6bNS++zgiXveahjLwBHqU7maRa" +
            "vLd8ITvamOk6PxKsuX8smTgw6SI3yFsvOB/5O7dCAQq4lRYeOYZfHztinDY5LX2Ou7tt7zmTRwK4v3qsuNwYyjhiYPY2iZNSuNBMhLeQpdE3ObL+O9zwbDxnQeK6oJuiuz4zLjvYTJ+5Qo9QuP998j" +
            "m3aEO4usaauFvzgzV6k6g1vMZBQEM/0L9rHQfAxhU8P78VTL4wPd+/H5LXPirsOT2Arba9bitnPRWt/Drv+7O6BD/UPg9NLj9UYl0+4lIDOzojOkDnNzs7iISoOyHjdjzmVUy8OfC/u4sFLz/xtYU/" +
            "y2iPPvefGLxUtVJAyC3yPrAi6Tsslj29LlyyPc4SLj6AIxE+J2COv3Z07b53uje7J7OJPvVMFcCVyHo5Kr0lvHElXjxdLQO8Zpw4Pz9Ax75C1DK/ivQPvclxLr/kkYG/wIaJO3gwNL699Is+xkfoPr" +
            "rIGMD19Nc/MR4sQBHqRDt05vY7/hO7vw/bbz78YeY9HsEaP7q2GMBy05e/WR5dvRxkLzwIpyY/ha6KPoX/Fz8BLh0zP6v0D0LSi14/i3F4vfYZfr7Pma69IIiFvKvg1zs9RpO8+DqSO8q6FDtMgT+6" +
            "0wS0OXDisDi29WC4jzk3uKaYL7gUssw8s2erOzBtnrpx82G7yLAour/Vmrma+E45Xj3QuDd6fbiUDZq48tgCONL+iTgiA0u8uZyvu8/Jt7ot59K7X/KcO8g10zg927m3uo1NOp3DArnN86m4sngOOE" +
            "r8XbZDF5y/0nA0QBoQP8AQgSY/c0aUPddqXMD8DUo/Xj+2PAFF373n3ys+TGi9u3DVdb09iTk/Ufg7P71l1D6gmQ87r+UwQA43ij4/qS481J+KPHuQorvvjTs8/pq6Pxif/T5s2VY/4Qp4vNdSHUD9" +
            "pMg+XTd8OWnuEr4mLTo+B0maPlnNzT5j9I2/P8KkO8pT0jnvrL++bb8FwN3wvTssGdy5yx6rPMFYV7vhxpc/Uqxcv7bWeb/QWg+9iw4uvzLOxr8C8Iq8NaOAvp1Nhj68udE+8t0uwGuS7z/SAAZApN" +
            "i+u7NqMjyRP4+/uCyZPnW8LT7JGbk+G/kowAjDp798xBG98LNTPGMQ8j7O8N896mXvPgFeZV8/5D8cQoaZej9lP5u9aBilvnUQrr0LSl+8jRrTO2YPoLxkT687GnMEO7dSZ7rG++057AI5Oes8Iblp" +
            "GCC4Hrypt4AHOj1nT7U772k4ux1Z7Lqm9/i6/hWMudkOAzommQW63mo2uZTRFbjWhb440Fa9OMeAu7zshRK9Q563uT7ftLsUEcM7fCz+Oa5w8rf+z1w63Z8OuYPUurc8IXM4rCN8t8+HDcH+HLVAm8" +
            "4ywMmoNT4tdMQ+OIGWwNwKcT/i4gI9/1AJvcuWVD7jbv68Exv1vWtHgj9Uvfg+ptQAPz7LBDvKSClA3jKqPgOadTy1zoQ8qrnEOmwGtzxcHRZAav0nv3AEsT+AK168i3b2P1UV1L1dLNa7EqI8vs4d" +
            "YT707pc+o5VfP0HMvb+p8UO+/qpjOo0ha79FcBHAx8iIPI7zwDy/eSc8n/F9vL8O3z9yf5O/XbCHvzHC/LzGZJi+xqD1v+EYDr1WsIe+009yPhcSnD5fhEbAfqfRP5T8pz/8VyC8zeBiPJFghr9WdJ" +
            "o+qup3PpFajr2x/xDA5jykv8ehjbw6OuY7ps2fPkMoLbwY3os+AaDu8D5FkwRCuV4fP+Pfkb6lGDO+9Xl8vdjQnLytOEg76QQUvE1KvTpZBLY6zZZVudo0XziKjPy2nKUAOGpQnLbRksC2XjFHvMpH" +
            "2ropHlA6Ylqju6uhADqg4yw41WnGuC1BNjh/5se2MGzYtyKdQbdZfvM2ApsCPdjC2jtRjEk6GM6Iu/Fj3zrwV9246gpeNgDnbDnrTpW3wvNWuNS3KDZCPqO2eO2yP7Sa1cAuWOO/8FqnvqK8jb1gHo" +
            "+/6HJSPqstN7sJQ369fGOyPFtl/rvOQ3m7Rqt4PtccQj/oXUc+NG+2Ogn/H0CHcnE/5giZO//LAzy3kFG7dPGSuyvUDT/mX5E/HnqmPjcriLvUDFpAoSOxP4AdajvrFS68reAiPTyqxj2vboA+U5wi" +
            "v2CPdb9MbYa7vffEP5QBD8AVFuu6zveiOxImmLxYKFy9QLfDP+TNKz5vlXY+S6O5vAvgAL4p28e/ATx7u62tor1Aqjw+uyvDPj2AMcCZkos/Zy1UQHPaQbuNKgk8Fi3vvwJygT7Fs7a8IoQ1Pyu1wL" +
            "/F89y/IWMlvfxhkDoggnU/AtlBPrmyED8Bw0ITP+RMDEIfe1c/y+sLvnm3g767/qi9kL+wvPbIsjvEnIK8i+RsO5BQFjui9h66zuuVOeWhwDeW7QC4EqUHuPdrMLj3kbM7yz4NO5IAEToVzqm7NhRz" +
            "OVo0I7n6mjM3hX+AuPntIbe0coy4E1CYNn0F/TcavjA8n+OYu1+iTjoO/tm7yyaBOwoTnTm1XOk2gM4oOuqPn7jJcae431XwN2J8rbagYYS/cgYZwP4QQMCKF7a+TNJVPonoL8BaRCA/p+Hduw9q07" +
            "3jT8k9UvYNvHCrRb3QIiU/zRtLP1WP8D6mpTA7RdonQI5ngz9xrks8lfdvPFDQlDu5mj88+BGnPwjtUD83Omo/UDCuu9nJNEABVY0/2NKXO6SqTr0C9bs9QW9APpCJYD5zLgG/Oqd4vyjypbqG1pA/" +
            "dvcQwBI4mTu/+r08Y/sZvSYFv71P+uo/qXu+vhkDn72M88u8VqFsvhB+AMCfKKC8jSUfvrBCQj5ye8A+du5JwD2k7z+V2iJA8lXmupK26zsmC7G/0Sl8PmGg7TxkLfc+OEjbvzmF2L/XC/68xaHOO8" +
            "JfLD/Wt/w90fb6PgG7fTg/tzoaQnROdT/0tfG9+garvnnetb1dE6C8tKLMO1OfmbyPB6I7P8saOx3pY7oNtOw5Lj4SOe2DFbmYMCi47R4/uMPXzjx+m4E7INRWukbjbrsgpTS6QWyQuWfshjk5F8O5" +
            "1XyjuAbJfrjsI2I4LaWIOHFrQLvmywK9ntO7OgMWxLtXS6Y7XAQuOijQGbfa0Uk6FsTKuLTdILhPPWM4FfYXtw48+cAbYDc//8A+wGavNr+MtAM/m597wIvZVj+kBSg8VctovXa0ET5djZe8+krZvR" +
            "SQiD//TfA+qU0lP+EMVju4+yRAJVhOP//8nTzHPaE8ILpGPOOExDxNKQtAgv7UvJBdtD+/slK7A4clQCeEtT60zxc8VEWDvYbW9D14MEA+C9lcPpfa2r4pV8C/Hmoku4ZIGD+jHRzAPJYCPPjXID3H" +
            "Jme9PizTvSVEBUDCcye/cRz8vn88x7wIaQ+9zq0QwFTREb1HeT6+IuMxPv5YkT5fgFbAT2j9P23txD/XFbm7hd0BPIm5nL8lpIE+5YUTPoPxsj1Ru8O/7arJvyfZbrzvElo7FO76PiANpTnjC44+AZ" +
            "JN0j6JmARC/lU5PxCAo75cM4C+zduFvcHE37wlqmU7i7IgvHs37jpwVPo64januWsKAzkv2rS3Y4MetvDjKre3zNK2+WSWvJvsp7scMMs6oLPdu8ITNjobUU851IzSuOcmsDfZtPW2HlcOuBs5DbeM" +
            "1gI0+D9gPSLFDLzCmEg7X4Gquw4BEju0HNo5nC0eN0wWnzl7wZq3SE52uGJYYzcRsQO310bmv39qN8FjuA3A57umv2TGiz64Iru/TZKNPqLxDLyuvZC9rtu1PLt1R7wyzKy8LDWdPjrLXD//f5Q+7z" +
            "EjOyxgDEBwVfk/ltlTPHZeGzw46Aw8ecGzu9WCKT944Ic/Pej3Pig+bLluRypAjnsJQPn+EzxWkD+7LBH4PEJZaT3bVUC+h72mvRZN6b+VfWa8kxEHQDo5q78pLAi9vEWGuxGLXr0OlpK8UdgHQAbg" +
            "2j71hdo+KmZyvIZKjD9Fsg3AvLORvAAaZb2fYtI9bxyLPhJATsCuzi0/UQNIQCB2MbzZQdw7IEzevz5Ggz5bLBO7oZgoPyAUGb4Eqv6/pHCAvBWMN7vBcYo/p71ZPWL+xj4B2RrwPqa4D0IPtF8/hX" +
            "smvtuUpL6heaa9gULXvCy9oDsUY3q8oAhjOwK5HjtqHCG6QumsOX4/rzf76pi4r77Xt9wTI7gSV3G7kYFaunNqmjrTy9S7HLYaOlgv0bZtDQq4SWTQuAyXZbbLf4S4JUsONwYyVDd9a/c8Z6mZvPvb" +
            "MDupasu7FAFuO4S6HzoRFCk3yk8XOte2Urh1aoW4iMkOOOj/y7ZzWojAk47bwN75N8CE9Z+/vQngPhvbJsD/jBQ/vFYkvKjxrr3inYo9L4IuvEkbdr03Jkw/M7gpP2yLED/BkZY7/UIbQAC7wD9nFc" +
            "M8z7+mPGxEdjx8lpk7awSoP+wfPD997EQ/T3CguaTFM0D25b0/5+9XPL+iUrz2NE09N/rEPezDvb6Ic/g9XxUHwJtsSrzojNM/2JPLv1BF4LzQbNC78Dh0vWjKib0lZAlAvet1OlslYL0dLJ+80w8x" +
            "PwVKHsB8NQq98e7VvZU52z2tHIw+L1hbwH9S3T8ipRZAfTdmu+bjuDs50Li/Wf9KPr0IUjw2L9s+LJYhvwNO7b/Ylli8JKVvuvilUj/9WK08tLWdPgE7Xhk/hYodQnBZfD+t1wi+2sPJvtXutr2E8b" +
            "68yB26OzxAmLzpCp87+EkfO95DXrohGhA680EoOYqSJrn+2ye4KHlLuJWbWjwWsbk6V+/Ot3OJn7sCwnu4SwADuZWBFznai9e5HgIkuFUnibh+qmk4peZiOFCrTTwPPTC9tchMO+JnubuL9Jc7SQ5P" +
            "OqwE+LZphTs6oDKQuCYMOreHxWA4KXATt7GlK8G8U0jAib84wEsLzL9r+iA/pG5swHKOTj8AOQg8hhyJvGnE1z3mVpi84GbivUx/lD99h7o+jkQhP5Prmjss1CVAJ5SKP8vE6zzwP/w8AjtqPI4JFD" +
            "xTzeo/b5aCPm42TD9XZOO5W3Q+QAalQD89R4A8oJhivH9NYD28dbQ9RQ7uvknzkj4AeiDANiZavLX/hT/r1+K/QC75vId9pby3A3C90mtYvY8mDUCNKzm+GDHlvhVSq7wR3/c+QYUewBH5Pr0Xqw++" +
            "cwDXPbmDZz6+mmrAWkUMQC4luD+UFe+6fF2BO4JMrL8wr0M+vlOgPYPZqj1pvzy/p+zJv5mXprtDV+G6yqcLP7x8Pb2L5Sw+";
    }
}
