using System.Collections.Generic;

namespace Alate.Files
{
    /// <summary>An object whose keys are names of the user's.</summary>
    internal sealed class MapShape : FileShape
    {
        /// <summary>Most members.</summary>
        public const int Most = 4;

        /// <param name="item">The value of each.</param>
        /// <param name="name">What a name must be.</param>
        /// <param name="words">What it is.</param>
        public MapShape(FileShape item, TextShape name, string words)
        {
            Item = item;
            Name = name;
            Words = words;
        }

        /// <summary>Kind of each value.</summary>
        public FileShape Item { get; }

        /// <summary>Kind of the names.</summary>
        public TextShape Name { get; }

        public override string Words { get; }

        public override IEnumerable<FileShape> Inner => new[] { Item };

        public override void Check(JsonPlace value)
        {
            if (!value.IsObject || value.Members.Count == 0 || value.Members.Count > Most)
                throw Not(value);
            foreach ((string key, JsonPlace member) in value.Members)
            {
                Name.Check(member.Named(key));
                Item.Check(member);
            }
        }
    }
}
