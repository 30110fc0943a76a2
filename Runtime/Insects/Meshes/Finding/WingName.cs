namespace Alate
{
    /// <summary>Meaning of a name for a wing: that it names one, its side, its pair.</summary>
    internal readonly struct WingName
    {
        private readonly WingWord m_Meaning;
        private readonly bool m_IsKnown;

        private WingName(WingWord meaning, bool isKnown)
        {
            m_Meaning = meaning;
            m_IsKnown = isKnown;
        }

        /// <summary>True where the name is that of a wing or a fin, perhaps together with the body.</summary>
        public bool NamesWing => Has(WingWord.Wing) && !Has(WingWord.Case);

        /// <summary>True where the name is that of a wing alone.</summary>
        public bool IsWing => NamesWing && !Has(WingWord.Body | WingWord.Mount);

        /// <summary>True where all words of the name are known and name a wing: then the name counts for the objects below too.</summary>
        public bool IsPlainWing => IsWing && m_IsKnown;

        /// <summary>True where the name is that of a wing's cover, or of a haltere.</summary>
        public bool IsCase => Has(WingWord.Case);

        /// <summary>Side that the name gives, if any.</summary>
        public WingSide? Side
        {
            get
            {
                if (Has(WingWord.Left) == Has(WingWord.Right))
                    return null;
                return Has(WingWord.Left) ? WingSide.Left : WingSide.Right;
            }
        }

        /// <summary>Pair that the name gives, if any; the upper body is not a pair.</summary>
        public WingPair? Pair
        {
            get
            {
                if (Has(WingWord.Body) || Has(WingWord.Fore) == Has(WingWord.Hind))
                    return null;
                return Has(WingWord.Fore) ? WingPair.Fore : WingPair.Hind;
            }
        }

        /// <summary>Reads a name; null and empty names have no meaning.</summary>
        public static WingName Read(string name)
        {
            bool isKnown = WingWords.Read(name ?? "", out WingWord meaning);
            return new WingName(meaning, isKnown);
        }

        private bool Has(WingWord any) => (m_Meaning & any) != 0;
    }
}
