namespace Alate.Catalogue
{
    /// <summary>Trim table of the painted lichen moth, made by the command line: trim painted-lichen-moth --bake.</summary>
    internal static class PaintedLichenMothTrims
    {
        public const string Text =
            "AQAAACBxA9wFAwAAAACamZk+ZmYmPwAAgD9mZqY/mpmZvgAAAACamZk+ATvlQz+XzBZC8vdrP4/Sfj2jOKq+mnOyvUWnP7wTXQ88GVSavES2ojuN+vc6giNFur95CzpHCns5bXpUud9aBrejicM4QR" +
            "lePfBryTv538y7dNwSuwB84bpMp/43/xGOOWIelrnyjyS57DypN4eoSDjkicI4DNb4vDnoK71hBlO7My10uytbyTu0iQc5f2tquXK5YTozfly5uk5NuPkqJTj6qpa3yiggwRTL50ASRui/rtvIP3eB" +
            "yT3l9JTAQsVqPz0Rcz73Zo+9lCGbPlWfCL3gG5q98e5EP1DF1j4aM9s+x3IGO/23PUCKKB2/BMguPCdMnjyz4z+85KNtPHEauT8sm1O/VmVQvj1q4LxqDOE/FiyWPNqE2LwDsIy+uwaJPm52nD4sZ4" +
            "Q+hnIrwKeKF79+Kpm8KH3SvwCIq7/bL7O8xs09vnstRz6WBjo+ryM6P9g4378W7SHA7do2vVXFDL/yZIO/+/VBvTgru770K6M+Y8q3PmPjEsDcg4g/YW0HQN6AfLybHrI8WtFfv83EvD6aRMA+bucm" +
            "vtB2Z8AuY52/BBkBvY2aTzyfiRg/zta6vRTiiD4BUieDP07xI0JFe4k/Ro19PEaf477SuJe9wzuvuzJH1TtAAZy8TyKpO3ljgTpLakK6LO3qOU9+nDlu9oW5bNvPN/J/KDkHyJo9CtsCO/URDrxZxT" +
            "s6WTVTu2UkITpVzgM6LCWEukkioLnoIik588H5OIyHbDjXrFu9/b67vZuKyboTJwm71YsCPPUbujnLrIu5OaCEOt7jNLkIR0A4SIZdOCxqHrivb77Bls1eQb63jr83VVE/HDCYPigK1cCFgZo/9reh" +
            "PpQZoD3RcpA+eSmmvRVu8r16l3I/k934PhLFGD+GzoU7t0IgQPaFqb58sJA8CWw1PfEVBL2MSAI8+nfmP3Zz4L9crvg9RMyuvFT+4j9bPCi/sBUvvUSNkb7lRYM+oYNTPqPBNT8pbH3AUCc1v9Dln7" +
            "xgmQXAvkSUv+XlEb3rSmi+cLZmPuF5HD69+MM/wqAkwOPhG8CclzG9e5KNvnWTeb+/qZq9aajqvs++uT6O2YM+SVpTwCZhiD6KgMY/H/WDvJbQ4zy3NlS/f2KfPmpkuz4I/CS/UOZMwMtGJL/Tdpy8" +
            "8zNGPCMjZj29yQu+3RhQPgFmdqc/cqEpQlrPkj9H6v29E57qvsCDer1raou7NW2uO4iamLx88Z47Zsl5OglzVLrmL+M4GP+sOXZIirmr5Xw4gIYdOfSttD0sfpg5LDsdvKLu+zpz3ZK7tESLOnrcVT" +
            "rt97q6n8zguQrjbDnAoyY5k5miOH0Hgb1dlty9y4L0uWMBkbr1FxM8VWhUOqFyormtXoA6B8sEuYRwuTj+7pg4UJ7/t2J+58GgaIdBoikcv7Legz7+RDM/uUr4wINlmj/Ov8I+0rsbPutCXT7fopa9" +
            "dlguvu6PcD8UfCQ/W3MGP8vGpjunCSdA9ZUQvms9xDzi5os99A1lvZu7qDoddgdA5Kg7wCrmEj+176y8C7SzPwpFeb9rGIa9IVOsvi01oz6OljA+flG5P+dYmsCRxvC+SaiDvBJu/78Gvau/a5zMvF" +
            "NbQ74R61w+3ODwPSTwA0DYqzzAoRAAwKzkH71pPU89nRPAv74Cwb0u0+6+xbLAPg2NMD5wgn3Aw3wOPuvpZT8jVCi8RKzNPGppcr/UN3Y+Fa2wPshnor9fwzPAT+yYvh3HWrxu61I8biZ2vkNUw707" +
            "2mw+ATugIT8u4gdCnxFTP00TH7xk62W+ZzOyvXR5hbzQfgc8WguUvNpDjjvw5R47EiwruhR2oznDp+I4TuUZuITyJLiu+vG3yi+9PPOkxDsOtQa7xiV2u2Fx5Lkh9Sg4FdmaONbOorZFEtu3wt4JuK" +
            "wgiLZM7pU4ITd+vDqKhDvYT3S7pxvRu2wZnTuvCDy5DAY1uclHXDr9fyK5zVzbuCvQnjeXOvY2eEheP6osVUD4cTLAQHrQP6QN+L0XQE/AlYZKP5xIJj4c/QW+gFxGPscBRTzy5/68QP4iP2UIIz/l" +
            "AsU+TdUtO0gsSkBPPJ6+6vEMPIedrTzLDE28zuTtO3PVbz/m6Qk/jjvnPrZpk7xC4g5AZpLIPgEqpTqTZB2++ABJPgcSkz6kL+m7mQTDv2+fpL3xNc+7dsdQv9DF5L89cmK7vtSBvdZFsD29On89Uk" +
            "SxPgAOjr+YEtm/8vQuvcToLr8/9Y2/wjlCvJ5Olb5gOJ8+anThPvyWD8AoztU/7BUVQMvTcruuGkE88biOv1mLXT4+gDk+KoQBP+W6QcDViJe/la5Jvd/jhzw3tRQ/t9SBPoipCj8B/DBYP/tgGUIB" +
            "93I/BDR2POhWob49Eqm9L+Q3vNpH9DuJfp28/Q2pOzVkBjsJlli6PmjkOQHTPzkw4gC5joQZuPnrkTdjIFc9wILPO4hXl7sN6uG675gQuzsfFrkDYAM6ODXkud+bPrk28dc3FAWROME0oDh1AgG9xm" +
            "EOvbmWJ7uZ0aG75DbMO017rzmWPR65tvNiOkXcOblLzE24nIFDOAH/R7c/6wbBBYH0QAmZHMBeIqI/aSeEPo2rmcDXYXA/gfYnPmDuk7041YQ+eNy/vLr2ur3yzGg/PlL5Phrj7j6hRsE6i3ooQOGk" +
            "fr6zWDM8ep9ZPA6SBbtBHtY8nWHdP0beRr/q6eg+dUHQvKnl0z/LCUm+/47AvK+GiL6IP4w+xJG4Prx37D4OxxXAk9wVPAXsHLwehvi/FOervy8O4rsRrdO90WUGPumxAT4xzXg//cfEv4Z38b8Vuy" +
            "G9Q8XYvhjVu78WAhy9wVamvrXGkD5U6bI+IFMlwJCDmD+rq9I/DYeCvJlasTyqr2S/jXuUPizzqz4OwI28X+tDwHQ7kL9bvsa8T8wsPN51pT5v3Ja8IYGPPgHts4o/1XUiQkH9hT/0TZO9c1C8vlah" +
            "mL3plQO8gTPKOwxsobwA+q87PqjIOvB+XbpwkMw5hf9zOQPeTLn1rgm3m9U6OA5Yjz09o5M7xZjHu9OYFznhBGS7iDVVOXLmTToeHni6taGoua96pjj4qRM5wB2wOODKLb1TLIG9m5GVutJ9c7sdZf" +
            "E7JKYVOmfZHLnVYWY6afEguU8F9ze8ooQ4nLDst/7VgcFIsC5B8hX7vx9MGj+4wfE+XyLDwMvHhD9TvjQ+YQZGPbOFfz7H8n+97ykQviUUhj/o2dM+f3/mPqLgJDuFIiZAqD7dvMW4iTxEKe08ufiH" +
            "vP6zUjz1sxlAc/n2vz1ZYT84lrq8otWxPwOzE78kYNe8O5qivrkcnz72bZw+kpOgPzx2Q8AhSUi7hhIFvEliBMBEC8i/S2qTO5xrur3YpgI+OQvUPdRa0T9Nq9m/gPfdvw5UDb1DcKC8DLriv0lrOb" +
            "0lp62+7COMPvpGfz4xgU7Ab49tP0lHgT9c7z28UH+pPBqmbb/7QZw+LsqlPgpNA7+YnibAp95bv1pOZrxTzQI8TUkiPRKicb2rFls+AVBpCT+GkwRCHp0vP6zpFr6dey6+7QOXvbZ1jLxzx6Q7gYFa" +
            "vLc7ITuSa+k665mrucNJmDhTWyU3BKEvOLLyPLe8iAq4FuofOWtbHjv9TDQ5aVeOu0Cb7jlKbwm4OUCruEr5yTjiM/M2ybtSuJJUg7cw1dE3PSsBPEfYbTz6POO6Wlaiu0jzLTsNkKG5WUlPuAEE8j" +
            "nue0K49UGauIzAfzUnVKw1ToRCQE8507+u4wbAOOg8P3b7Tr4h696/5SPXPs7TOD38Hra9KB9mPaVC/zr5q626DyLUPq1TLj8WdFw+r5gCO0YWOkCkKGo7vNinO734dTxq50q87LO8uwDxLj9mzYU/" +
            "xfOOPg8UGLyqylJA+WXyPnE56Dvsjzy9+1iyPXctLj5CZBA+DV6OvzA+7r6Nnje7FJuLPi9cFcBqJoc5UuojvFonWjxrXge8gzU4P+rEx7550TK/IbgPvTiDLr/+p4G/D1+KO6SnM778+4s+nJjoPq" +
            "ENGcAyU9g/pl4sQA6PSjur1fU7OiC7v1OjcD5IR+o9iVMbP1aPGMBjope/rQFdvS5TLzxWzCY/EKOKPgYpGD8BmgkzP97vD0LUfV4/QEd3vZNofb6Fkq693GyFvBBu1zvsPJO8DQGSO4OXFDv9Ez+6" +
            "BvyzOYLcsDj8E2C4eYI3uEvRL7gDwMw8v+CqOxmDnrpQrGG7atAouoAmnLmlLVA5pHrRuGSOgLi/g5q4deIDOLFbiThNvkm8dvisu9tNuLrUvdK7r8ecO5EWwTjm7bK3SD1NOhGBArmdrKi45GkOOH" +
            "TKabYuvJm/i00zQLXmPsAY5yY/OPuHPZooXMBxtUk/fkexPPHy3b1YYis+pEbBu/chdr2hmTk/zyY8P/v+0z7zNw07JNIwQDX7ij61jC08l8qIPEPkmrsjBT483Ti6PylFAD/FsFU/zD54vDuLHUAt" +
            "x8o+/w3yt9GoEr72aTk+VzCZPoauzj5Noo2/BoanO72suDmYEL6+zMUFwKCJvDvPf0W6rMutPGIvM7uHs5c/pwxcvy0ee7+uoA+9UOgtv+G8xr/30Yy8iNWAvvRAhj4HXNE+Or4uwApe7z978QVAts" +
            "24ux2VMTwYDY+/QneaPmofLj5ydbg+ZBQpwMyzp78WbBG9ZJhTPLBP8T6lpeM9rULvPgEhYl8/7DQcQuR/ej9m8pq9pqCkvm8Arr3pKl+8PnLSOx8HoLyn+a477TgEOyZiZrqRAe05mno5Of1VIbnn" +
            "rB247rWpt1oXOj0k1rQ7oTc4uxEf7Lrt2vi6nneNuVdVAzpHbgW6vZA3uTB/F7hOXsA4G++7OAsYu7xS9RG9NAG3uenwtLvu38I7eyj4OSsE5bdPW1w6Pk4OuducsLdkQXM4Aft8t5/zDMHjq7RADc" +
            "sywK32ND6mc78+MlKWwLqZcD+hgvo8qYgCvduLUz41Bf+8Gqr0vU7EgT+LBfs+/EoAP9PnBjtrhilAQvyqPnPldzz5KYk8oPyPOi8OtTyyixVAX/4jv5mysD8xC128OLP3P9Hpy70dU8W7tK46vvUH" +
            "YD5bxpg+BoNcP3xCvL9w3EG+ZMl2OibCaL+djRHAoLOIPBLfxDzK/xs8w3KGvJCI3j/l/ZK/8f6Gv0bB/LxqUJm+6GT1v/KkDr2/YYe+7CFyPosGnT4b1EbArAjSP0tSqD+bVx+8sYZiPM9Xhr/sIp" +
            "s+xM53PkAUhb3wQRHA6Vqkv5tYjbzK6+g7yA6fPuygHrzvAYw+AdvY8D5MkwRCElofP5zPkb4vejK+zIR8vZ6PnLxH1kc7zfUTvOb/vDq6C7Y61rxUuQJLYzhJ2c62xxAAOKcQkrbIUue2SjpHvKAS" +
            "3LqJik467zOjuyZ5ADr5jCk4j1vFuCtCMzh0tOC2kpnZt9TsQrcDYgM3+QYDPcXc2juLtkg62uSIuwUu3zqqjeO4/v9lNvWZbDmqqpS3r8ZVuM7FNTbQJ6G21QGzP3lL1sDNfuO/RK2mvrm5kb3E/I" +
            "6/9zRSPsYMQLucuXy9PGOxPGgA+rsF5Ya7yOF4Ph4wQj/OuEg+U+u3Ojj6H0ClqnE/YCWZO48HBDxuelG7F/mOu1ykDT+QbpE/R7umPoBeh7tA/llAxGGxP6NdajsQKy28hRkiPW1mxj0QgYA+XMci" +
            "v3tIdr9Ko4i7uhrFP4EYD8CQ6+y6di+dO1v+lLxpZ1u9rKrDPyhtLj7HYXU+Fpm5vOypAL6C0ce/pXp6u5itor1uVDw+kgvDPsRYMsB6U4w/CfxUQLWEO7uNbAk8iL7uv7/JgT5Woqm8UyQ3P0Qcwb" +
            "8Q2d6/fgMmvTsihTqrdnQ/BNlBPgiNED8B9zcTP7tGDELoc1c/F7oLvqJgg77oBKm9loWwvOdhsju9koK8tZ5sO2NGFjuMlB66NDqWObzHyTc+BP63N9EFuMxJMLhIxbM7WgkMO+uhDzoQt6m7Wxly" +
            "OSGSJbmgJTo3be6CuKldMLdXY424Rm6bNto8/Tfe/jE8/wSYuzizTTooRdq7JhKBOyxpmTnYIvA2EawoOt/4nria+aW4eDPxN8Poq7ZimoO/uhQawPtGQMA5SLW+5r1QPrXCL8A5JSA/3wjouwnk0b" +
            "2xqsg9aGIJvF49Rr17QyU/a+9KP4Qn8D542TA7+9QnQMNfgz8T3kw8TbJwPHBukTuE7T08vkCnP2uxUD/hgGo/Qwutu6LJNED1a40//naiOyBSTr2KTbs9jFRBPlnJXT6Z7wC/Lq15vxHiq7rYKZE/" +
            "A/8QwDDekDvIGL084j4ZvUb3v72o2Oo/67++vgXqn72YK8u89HlsvuV6AMCIOJy8HrYevrx1QT6jFcE+cQhKwFMq8D/oySJAQXzSutoi7DspErG/DZB9PkGj8jzyD/Q+/szcv48j2L9o4f+8B8vQOx" +
            "zwKz8AKPo9SpD6PgFnSDg/Gy8aQnpJdT+rHvC9m7mqvlPctb0x8p+8eQDMO3ykmbztxaE7O8waO/c4Y7rtxew5Z7EROVe8FLlphSW4s049uLe1zjzRAIE7VJJWup2XbrtGzDO63W+SueijhjmYzsO5" +
            "UhOkuIzSf7gq9GE4em2IOEMRPbsOgAK9o/e7Oq2hxLvDL6Y7NwIrOsw+Ibeg1Ek6gpLKuL1zILgc6GI4780at7ib+MChFzQ/Iz4/wPXUNr8YYwE/2md7wKrbVj8FQys8pAxmvYpdET6I+JO8bsHYvT" +
            "IGiT8pQvA+GeUlP7NwUztd6iRAo8ZOP4O0nTwhIaA8NC5IPMkZxTx2EQtAn+6tvNX8sz8nX2C71LElQG4nuD7EcBI8p3qEvYt29D0NjUA+KrFdPtBU2r6ZWsC/Muoau7GCGT8QCBzAlOwGPPjOIj0U" +
            "Mme9hujTvSVLBUDHPCe/x6f5vktTyLyfjhO9XqEQwPRKEr1q9j6+tR8yPkf5kT7C11bAq7L+P6kbxT8FN7C7qJv+O2CfnL8lIYE+sqEOPugipT1EcsW/bdzIv9/EdLxBCmE7dpL4Pi9olDoT1Y4+Aa" +
            "0p0j4pmARCZVY5PyBio75+z3++heiFvURS37yFeWU70KcgvCsc7jpqQ/o62SKnuYd4Ajnl3rm322dFtjVrPbeOrty2koSWvCplqLtTxMk6HH/du238NTq4pU85KyfRuFNLrzdF/+22/C0PuCfhCLeh" +
            "Kk0zpX5gPTU/DbwSQ0g7Ndaqu7zhETtzfNg5Jm8oN7o1nzlNNZe3n4B2uNxuZTcdeQi3Ew/nv86dN8FxAA7AD3mmv2Gvij5d+7q/tLaNPoF3FbyAaZC9e5uxPIBuS7ytLa+81KabPrEkXT8xCZM+QP" +
            "QjO1hEDECznPk/jIpTPNC8HTzhCgY8Lwyru7LyKT+c/Yc/uDn6Phn+37hJPCpA3nIJQHjWGDyQmyi7zan1PHuqaj332kK+I2OuvVie6b+g32m8cggHQKK3qr+6xQm9+8mgu8ScWb2Z+Z68wsMHQP9B" +
            "2j5MD9o++qFwvOR0jD+uqQ3AjY2PvC53Y71F/9A9Iq+LPilyTsAbZDA/XgdIQOFtKbyLndo72Fjev9gRgj4vXRu8pSQkP+mjCL4NEP6/AT+AvI+yPbsQeIo/aVdaPST/xj4BdOjvPvazD0LJsV8/iy" +
            "smvvpCpL54gaa97vLWvA9eoDvRWXq8PdRiO8LCHjv1aSC6CBetOUzPsTetSJq44nzbt5yiI7gSgXK7UEpguiZKmTq6tdS7dZUaOg4XGrdwxg24WdrRuHQthbYn0IK4V18VN6QEXTdwEPg8pY+ZvCgs" +
            "MTs3BMy7fMptO0upHTp5JiQ3w3AXOqYDUrgh+4S4fwQOOPgjzbbMPojAPBrcwN59OMB5PKC/ESbdPgmyJsDMrhQ/aewivDcerr3Rm4k9CpQtvNH9db3xe0w/4GsqP3LBDz918pU7rkIbQK0MwT+Opc" +
            "I8g8SkPAOHdTxucow7R/mnP7y4PD878EM/TFiwudOnM0DPP74/l2xWPABFV7xlaUw9T4TDPSsrvb51MPk9Rq0GwFNbSrzRn9M/DnHLvwaN37yF2MG7c5Fyvf22hb2DbQlAiUksO9QCYL3KlJ+8ynUx" +
            "Pzc3HsB6jQq9CznWvfnb2j01C4w+MbBbwKKy3T8KxBZAApFfuzCtzjtLpbi/sYFGPrivMDwMNuI+cRclv2es7L8c+Fu8urGHuosKUj+nBcA8hcKePgFlKBk/boQdQtRNfD9zAgi+Q2PJvvrntr01sr" +
            "68CKi5OytKmLxQkJ474wMfO6AUXboHCRE6CvknOesjJ7m/5zW49HRIuM0wWjzWwbQ6GX4VuCJBn7sYoFi4Tr8BuRfYFzn0JNm55xkmuHChhrgUUXA4aMBiOEfWTTwYsC+9mcNNOzuuubsn4pc7hOBK" +
            "OjtBJLciGTw6fDiOuHT+LbcgtFw4CiQmt6AVK8GHdEjAHv84wHgGzb9Qwx0/MkNswEEaTz+IzTM8fq+CvByQ1D3vQKS8KDffve32kz/SWbs+CKAhPzKDmjs0+CVALCKLP4mY6zz++f88bBpsPOJ7Fz" +
            "yMhuk/R+iCPklGST/KJfa5YWw+QBkfQT8HeX08Aw5mvOT0YT1j97E9ve3qvsj8kT6nESDAatFYvAcahj8LwOK/fUn4vGIBqrzAIHO97bpXvcuSDUBv5D2+J+DsvhQpq7z/dPc+LJkewMipP71DChK+" +
            "Y0faPSNxZD4aRWrA9F4MQPE2uD9o3N26IvJ8O3QJrL8gNkQ+zx6fPTZquj1euz+/bAXKv0pBqbveJ9a6D/ALP4WTOL1oCy4+";
    }
}
