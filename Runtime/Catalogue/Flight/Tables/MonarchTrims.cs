namespace Alate.Catalogue
{
    /// <summary>Trim table of the monarch, made by the command line: trim monarch --bake.</summary>
    internal static class MonarchTrims
    {
        public const string Text =
            "AQAAAKkULcsFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+AdQPKD/2LztB9YOHP2JIhT0mAq++X5mnvnnoC71Acxs9gAyCvWnnXzzQdAw8tEwnu3K0hTo/zyk6YGUeu/TVbzpXPXU60V" +
            "MoPkag/ziP7xq8DrfXOwvHk7vnHUC6n3s7u9vrPrtYXxM6nebOuFpcjzcG/Dg6zm1xvmFamb4vOqE7UPXNvKfF5jzKMYE2PxJcunELtzsKRKu5iRsZusreGzmNlpg4vq+xwdyYi0ES23PAtctFv31u" +
            "7TxxQ9fAiwH3P0VWmT5C24a+b9I+PmWMxDyBzIa9G2R4PtEFjT/4w44/hQK+PFU7Qj/tXb8/N8z8PBfHLj5ahuO9G82LPSWhnD/DNZa/HS6sv972Ob192Dg9h6FQPxp/zjx+Sry+L0FBPhwLt769YH" +
            "M//b5wwLZha8Dqvry9RqpKwEnQRj4V37W8rU0fv6D/1z4yMmG+N49QP+XLc7/F+7G/O9onvYhRbD9K3IG/5gUdvErLgb4yQkY+IbOsPoAy9b+NsU0/CfVkQOKCfbw6oJ49RB8gv/B4Oj9JyVM/zexJ" +
            "v9L5ZsCUbi/AshmWvVoPFj22rHo+AzfsvjiXLD4BCANGP8sUR0GB7J4/z6dCPKaG5b4J26G+QMaevGQvOz1OnoO9RusbPPrlKjxqKDu7kK7qun4bmDoMZmW7GWjUOoC6ezrcrDs+1RFgvPASL7xx+K" +
            "A8PfHIuyEXTLtF+5y728mAu1AvmjoQKRm62W+puW9wljpAC6u+BSvJvkqOnjyXC8q8U9j3PDXfIbuUmRW5glL9O2tGKzikqZa6vt29OZa6ujnP8ffBQs3SQSsZgMDnUkjA+/Qjv7wV+MBzHjdAlgxx" +
            "PWtHHL88+4y8x+qMPlhojr4PiaI+FRqTP18zlz/u37I81w8jQFs+Dr22TzI9ECobPgPkDL415OW8/nmnP5IUEL7Egie+IFVBvFQSPUDqGh+/WP1pPGvoer2Dfjg9JQUHPkRbiz8KgkXAP0IOwE41Nr" +
            "1BrxO/RD7lvwWXqr1AqXq+uGGBPrmUQD1hZ6I/b/DmvwzaA8Aa81S9o6k4vzGLCr6dGVC9FXuvvqQBkT7vsUs+4utjwPX25L8TUXVAuB4qvdhazD3jSZq/SNahPh+tFD9iXZq+sYorwKMTKcBX+hi9" +
            "3XT+Owsm6z4ney2+FPqpPgAAAbV4RD8jB0BB19uMP3FSMjxu26u+RPaivoLX0Lyhvw49WemGvZyykzyikd87ehNHu20LqjrWuow6wtIIu2clTzqtHFM6c8Q7Pu0Ud7rUwRG8H3sGPOA2C7xjnIo60Q" +
            "M2u/EXmrthZZs5BWKMubwjIjm66Bo6QIWAvrI4m776hns7cSDPvKYR/jynatg6tklbukDOvDs4ldy57iVMuSR7ozgIIYc4vGi4wVCxmEGRanzA6h8Zv/iGzj4LwfLAZ5UAQC9ClT6V0L+9kx1OPrtw" +
            "MD2L4VW9rlIGP0s9lj/DUII/CVy2PLb2RECxscO+7lMKPbyaKj5datq9C3kXvR6EvD8tTjK/3eqpvlbvqrzzrARAoRosvyxtKDzXIyC+ROyiPTvCEz4j804/QwdNwJDaEcCfRWK9W3akv1Hr3b+aTy" +
            "a9LE6svjaRgj40yVE+8UFVP2MPtr8HGNi/RIZfvVeaEb+Jc0i+Y/CmvKXQvb7V92c+fS+/Pk2gBMCAgZy+gHA9QEa1BL2tp5E9gZeIv12joz7hcPk+2eE6visxHcCKLyDA8RgzvVWPJjw3mNY+nH5U" +
            "vUZ+xj4BU0trP9MLSUG0y6A/Gl+qvUd+0r6v/Z2+T09avMXhKj3wJ4W9f3l1PBD1ATwaBo27mlQIug2C2DpVMnC7HHLTOqtauDoF+lA+QztCvF+DP7xc9pw8aYAlvOfSALoPi5K7XG7gu8Xokzpw/l" +
            "A4JhTut059XjoUZqu+Mhe/vrOxTDxeIb68veIJPQtehrr8HgO6x5XxO+l1Izmdzxi65mvfOGiEwTl+ze3BclbVQakBc8A2HwTACoKKvmSFC8EcPC5AjDEyPn6gpb6Nn6O9FxN/PpFZiL08Nac+h3fN" +
            "P6o1mT9CEME8cFUzQB0NZT7RRX89BKsDPvQdEr7ID4y9HDiNPxutzT6ugVk+jAJZu8l8M0A8m5W+NtE6PZx1OrwKxCe84WyWPfGjjj/jAT3A7KLzv6clJ70FQYW+XdMIwH0wnL33ECq+EvBbPghFLT" +
            "5tgKI/r4/3vzrw4L9LSE29fZUPv8kq+775h528mICOvt0AfD4L34o+k41XwKzZkb9uz1NA8or8vNubqT1zMa2//SSfPst8CT8f01m+mDkUwDZyGcAgogW97vC0O2jIuD51br69yhSoPgHvUCI/Cfwc" +
            "QS0iVj+wJR68Oqwjvo4MlL74Jhu98NuPPHJkfr0WsGo8BNNSO74ih7nHJoc6GXIGODNruDmzXoA4PnHguXmtej2V9My40LVUO4EcILzxYvq692RzO2NJirq5ogq5s1EyuSlUHLr1zeg40taoOe2v+L" +
            "3Ks+W8Jtn1u+N+Eb3BLZo8ZSF0OD6h/jjkxzk77ireuexTETl7VqW3r4SDN3CG3r8A7fBAlXCPwI9kcj+xrDk8LPhqwC5PRT9oBQe9HMZMPQvRHD6q8+47tioXPLUEFD+IKVk/4fI1P4dyuzwt6WlA" +
            "jsw9v7yAzTyPkRU+nPOzvT+9JD4m7AI/8hZHPUS36zubdoS8KlOsPr5ynz7KfVm7VrLdvX7lsT0fgjo+nDSfPrKSCsBjjty//WxxvSGyAsCPfsa/mGS7vLO3q767mnU+K9KNvl33Kj/AfzS/2HmBv/" +
            "F8Vr1sCGo+ycAjv184dLxs8aC+Ih02PswvtT5Z04q/YMuSPwKCcEAc06K8kDc/PdUk0b9QWc0+QuTePrnQYL7y9OS/e6f0v5q/fb1ySEA8UQV2P6KTLD7l5xQ/AaLJOD/jKi9BlAh6PyO7oTx+Um2+" +
            "zh2bvqeX6Lw6TLY8FBKLvYgfoDzEEYQ7pHneugF7ATspECQ6qxFJuJkEFTkfr5S5FqQJPgPwJzqoHtS61JWbui/v87umlog75SGguomqOLuarQu6dPZbun/24Dkrxg863249vs55Gb7Xiru7eu0FvT" +
            "Ln1jyEDaA6QFV9uFkxejt8qh26BgLXOe8x0DcWsfC3XCAmwSg4TUFRbJTAhaFRP+hehz5Rv7nA1iqYPyGzjjwoOC4+sbN+PhF7Xbxg/8q8KDI5P9IyZD8AEh4/LQlnPE3oU0CYVvK+it7rPLyJzT3+" +
            "DJi9KjgzvSAvnT/nlyK+n99jvBnNorzurto/lUfCvp33Pzyjzie+2BTDPeaMtT7qpdY+Y7z9v4krqb992hG9dIl7vyou+L+7KYW8yeZRvqfTLz7M2hM+HwYvPyyld79oEI2/FA9JvWajHb/Y0+6+yq" +
            "MyvH/MqL7Khzo++lLSPhXX87/ljxI/0/lvQHqvD71254Q9aqGsv6kvqj5oO/M+MCeGvYpRAsAuvxvAUFpBvRz0BTynhiA/eDKTO5U93D4BH2JWP9RMQUErho8/2VMovdMgo76x85++RNGPvPVk7Dyu" +
            "s4u9+purPAj2ozsyOGS7WjX4OnbszzrQXtG6fZQLOlPHBTqS6jw+yft+u/5N3bsD7hk8N6owvAiaczssiQy7p2rZu7RQKbnwcge6evgbOsIfOjonN4C+wdOOvnT2tDltP9y8rOABPVvigjpgoiq653" +
            "OoOwZuobksJeI5Uo8COD94ATjx6KrBKWiZQROJh8ADWy29lwJzPutW/MDB8uw/tvZrPtkyUz6eXyo+oxiIPAYlIL0an+g+ooG2PyL6UT/ScJA86iZSQFNDZT7Zdao82Sz6Pfbn6r1bggO+nQbiP90v" +
            "377I4te8URhjvHVUD0AXxQC/7J9tPWuemr1mHJQ9D9CBPgcOVT8Yiw3A7Iuyv6Tu+7yT91m/neAEwL3+Gjs9NhK+QH8mPkSCPj7CuFw/xxOLvyBwhL/SLSO9gxkAv6K1Er8A1Yo8eH2Jvhg7Ij7gNJ" +
            "w+xgwcwO0Ktr2yxERArwoCvfRSiD1HSbC/6ufPPhkn+z5Q8oC+Pb4JwGOvGMDj4hu94b8ePDvczz4b41i9MDi/PgEYFQk/1VwVQUj4Pz8cKLi9g80MvlUIhr53fyC9EfUVPJxdRr3eyxM82my3Omml" +
            "/zkMSDI6yMFSuRXN1znyswe356tiuS4Ecbt1eB27PQyPO0jPerx07Gw6Wl8MO9HOWLr4d5Q4LedDt/KIrrkOpVu2PPq/OCpSW73Ntxo8mSm3u+m6D7256FM8VzWDuvyasjlspd4697MruThkDDiPpz" +
            "O4llWyNBQ9Dj8bCkpAIpuGwMlGKz8AIT6+Dg8ZwAET3z5t8rW9vcM+POA/XT0ZnoY6MNeNPA+b8D7MhVs/Qe7DPiY1KTyW70FA8qRfvVc1ijwqg4c9pEgWvedrLLzmZzc/mr1gP0qCqz48fRu8/Y8m" +
            "QAZK5T65eg08+HhZvTNxxjwLMvA+kQ3bPq5SKb+UNwO/Dx9cvGICmT/XUQrAdPWWO1PYP70XphM9spoVvv/JKz9X992+0QfivqFfEL1Y2zq/iKJWv1U64LpHUTy+eajzPQ6dFz8pv4+/gAZ4PgKhk0" +
            "DqOhi9HPUwPcLwDMC7hM4+/36tPiCglr5ay4e/VZv1v/ZDOb2HujW7iWOVPwHmHT61RBE/ARgUHj9z2SZBCSVmP0b9y7vLb0q+XBmYvkKHCb1Ihmw8Atx/vUIvgjxNkBQ7CozBuXqWwDoj1oM5h+bU" +
            "OdaJSDayk9i5KAaTPevShLp/tCk7E48CvIR1TLsSTmY7sBSLuv8IuLrtAJC5LqFkukg7lDnmyso5YScAvkdwo7022LO74HsUvf+RpjxxJiW5JqEQOsSLOjtjy6q5FiKpORhQCjgAQ1M3vHaowFQaBE" +
            "HcSJzAJl49Py6IB727VYjAf9BWPwBhJr7W9QI+rakEPt1jzjuG45C80LsqP5BhVD9wirc+ZNDpOwl2NEAiccc9I4m/PL24gz0p4hG90YmivLrUlT92ex4/mAGsPkNSD7wdLBtAHmGEPtEGkjzmOXW9" +
            "usskPcyt4T411s0+tWExv9MfBb9XryG8lqpLPx6V9b+sHIc7/wDxvIgVHD37pYy8+OhMP0BdPr94hxu/jPkUvZb+Pr9Zmni/DFgDvAFPdb74c/Q9QS3nPu+Z3L/7xMY+CRqFQL6JFb0/jVk9Ix3Uvw" +
            "aB4D7NQ8g+Yb9XvimUtL9bJRbAPtwnvXf5tjqoQ0s/h0CBPepo+T4BG3M2P5hvN0HJpYY/yghavOJ+j742nqS+mMmvvJiUsjxYc429CXGvPLNJSTs4jyy7g9EaOx6kvDrwFuO52cEGOYvofrmgng4+" +
            "gGGXuzof47oHfXY7gEILvI8lqTsbWbC6bZuuu1jRG7pO3Im6JdRdOl+MSTr/vlO+PUtdvkHhbbuoWwa93r7rPMEBBzpRyEc2gBGEO4E1trnkoFE64xHTOPura7jgJnvBY05wQThpnMC2Vwo/W8L2Pa" +
            "Qw18BT8as/OrGuuiQWvD7aLSM+LJoOvdM2gb3DwSM/Oo+FP6ND9z4bpRI8KnJTQHQryD74Hc48VO+cPYZihr2mo169eq3SP2uGtD0yzdc95cglvBjeDUB6Ohq+QNHsPBfVSb3PzEs9yiWQPvBUKz/I" +
            "hJ2/RIRlv8mHl7zsaKC+St0FwAGcBLt8nJa9COGvPd1eqT0KK3U/FthEv78eCL8rqP+8J70Ev39BXb/7N1k88GVvvuPj7D33tqk+KX4awNqHJL03DGdAs28MvUJpdz0gy8W/if28Pm9n0j6BFjq+dC" +
            "TDvyS8IcBTCxC9gv9JO1xMAj+bU5g8k5PZPgGcadI+BoEVQdMZOT9xXvu97T8mvkwJfL6ppkK9wInsOxGbHL1RI+c7Fz7HOnWtCzq/UxY68MlDuejbwTn+zDe3Ob3duMc8Eb1beEm7wksGOzc4k7wZ" +
            "SFg6fBWnOqTUDLqix9m4ep/VNveXcLltqbS3N0BaOBKSuDu5Dpe84u4xu8hgDL26TS48f84rur+8tDlTJZM6tPyjuB85xDYj4MW3pA0etxdLi7/IM6q+DI6DwCbGpj7uGPi97eP7v2iukz4kKrW99f" +
            "8GO69e2jzujYW7QeorPGMZpj7HmG4/fthDPtIHnDup8itA0AJCPzaZgjyGYC895VKVvOIGR71pWx8/KamJPzKFwT5BTYS7C+8qQA42lT/Q/jQ8K2djvCNcRjv1toI+32vQPuDqMr6cW3q+5LcUvNIn" +
            "6j+z6am/LIDauRkmy7w3nfa6FQnsvflVbz+gzxe+4wXgvBRb2bwmbZ2+DTulv2tSpLutQge+RDiCPT/nFj8Zc7e/BVOkvyuxnkAYOXa9nl4TPYUQEcDLedA+No2QPgcji777TcO+K24GwL+427zCHE" +
            "C825yUPyMWnT112d0+AVw8/D6o0yRBKB9hP/HneLz7g1u+DvWZvgYDI72k1EY8ukNpvcJdYzyA1fQ6AXy6uLDZqzq67mI5uanWOVUf8zVmb7C5xt4IPRipNbt/ZyU7Aa1BvO0KzbqfXEE7htFyunM5" +
            "wrrk0dS4+WVDur1IZjlpr4k5tvOsvZitur0s04W7Wy4cvfLZljy4URe5zY4mOjxSHDu1pCy5j0yaOYyFEDhMp8o3W/e9wGwGsED4/6HAH/gKP3Uw9LyBi3LAFtovP27xOr5xz+Y9RnKCPaadOjwWfZ" +
            "G8sjkTP1J0YT87+kE+ig5dO6lkK0CgaiI/D+O5POjGRz36gLe8Hlpvu6YlgT/3smk/rmmfPqlAibuhjSNAOatuP0oEuDwCQ1G8DkonPEOWfT6caqk+t+dVvlNVmr7oWNu7xZKePxDirr/3jpY7/tmN" +
            "vE6QUDvmyVu9hTCFP3Pc974BszK+yybnvJnJzr6ujq2/SBOxu51OQ74WApo9pYrsPl7+AMB0pBK/Q8KRQH6eSb3jlEc9T2rtv3BawD5AYZw+yRxQviH6NL9kjyLAgM3nvLu38rt2zlQ/Yj13PXs+5T" +
            "4BBZwUP0CiNUGnZ4Q/ArwDPPQqlr5Ruqy+Fme+vKUjpDw2AIu9u+qmPPpgETsKPB+74lkeOz4G3zrMS8O5ungrN2Ijs7kIctc9YUjvu3OrXrlYEtQ6cvHNuznXsDtfAqq6D9Squ0A62rl+toe6KatW" +
            "OoUIOTpQRD2+971kvkwgSbt38g+98xjfPB+PDjnC8AM5ZfJyOxHRNrnbfmo6ResDOaKbCrj4a4DBFYdUQaFipcAcTuc+TlL/PEcUyMBpMpo/D6klvSJGyj6sap49vY+ovJ94mr0rDxw/whuBP/xGpT" +
            "6Gsao7AMlFQO3dXD+lptE8dktnPWCgRr07Wnm811nEP0Lv/D4OPu49KGz/uzA4G0DJE5Q+qSs3PWH8pLwsW788soRmPuJqED/iGzS/tuUgv+YyUbw7q6s9j332v1EhjDtoMzm9hVE1PU527DzN9YY/" +
            "YcEWv3jWLL7sB8S8GqjRvrHPjb+qLKE8uXhBvskupz2Z+aw+110lwAPdD7+VdnlA9ZIsvRMSaz0a+eC/UV+rPkbaqz62AkK+STdrv4RkLMCcAOe8on5vuyZ6DD/syPQ8dKjdPg==";
    }
}
