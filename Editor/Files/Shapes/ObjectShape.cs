using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate.Files
{
    /// <summary>An object of known keys.</summary>
    internal sealed class ObjectShape : FileShape
    {
        private readonly FileKey[] m_Keys;

        /// <param name="name">Name of this kind in the schema and the manual.</param>
        /// <param name="keys">All that there are.</param>
        public ObjectShape(string name, params FileKey[] keys)
        {
            Name = name;
            m_Keys = keys;
        }

        /// <summary>Name of this kind in the schema and the manual.</summary>
        public string Name { get; }

        public override string Words => "an object";

        public IReadOnlyList<FileKey> Keys => m_Keys;

        public override IEnumerable<FileShape> Inner => m_Keys.Select(key => key.Shape);

        public override void Check(JsonPlace value)
        {
            if (!value.IsObject)
                throw Not(value);
            foreach ((string one, JsonPlace member) in value.Members)
            {
                FileKey key = Array.Find(m_Keys, known => known.Name == one) ?? throw member.Wrong("unknown key; " + Instead(one));
                key.Shape.Check(member);
            }

            FileKey missing = Array.Find(m_Keys, key => key.IsNeeded && value[key.Name] == null);
            if (missing != null)
                throw value.Wrong($"'{missing.Name}' is missing");
        }

        // The keys that begin as it does: mostly the unit is another one.
        private string Instead(string typed)
        {
            const int k_Alike = 4;
            var near = m_Keys.Select(key => key.Name).Where(key => Alike(key, typed) >= Math.Min(k_Alike, key.Length)).ToList();
            int best = near.Count == 0 ? 0 : near.Max(key => Alike(key, typed));
            return near.Count > 0
                ? $"is it {string.Join(" or ", near.Where(key => Alike(key, typed) == best))}?"
                : $"known: {string.Join(", ", m_Keys.Select(key => key.Name))}";
        }

        private static int Alike(string key, string name)
        {
            int alike = 0;
            while (alike < key.Length && alike < name.Length && char.ToLowerInvariant(key[alike]) == char.ToLowerInvariant(name[alike]))
                alike++;
            return alike;
        }
    }
}
