namespace Alate.Geometry
{
    /// <summary>Sets of numbers from 0 that are joined in close to linear time.</summary>
    internal readonly struct DisjointSets
    {
        private readonly int[] m_Parents;

        public DisjointSets(int count)
            : this(new int[count], count)
        {
        }

        /// <summary>Sets in an array of the caller's, which may be longer, so that nothing is allocated.</summary>
        public DisjointSets(int[] parents, int count)
        {
            m_Parents = parents;
            for (int member = 0; member < count; member++)
                m_Parents[member] = member;
        }

        /// <summary>The lowest member of the set that a number is in.</summary>
        public int Find(int member)
        {
            while (m_Parents[member] != member)
            {
                m_Parents[member] = m_Parents[m_Parents[member]];
                member = m_Parents[member];
            }

            return member;
        }

        public void Join(int a, int b)
        {
            a = Find(a);
            b = Find(b);
            if (a < b)
                m_Parents[b] = a;
            else
                m_Parents[a] = b;
        }
    }
}
