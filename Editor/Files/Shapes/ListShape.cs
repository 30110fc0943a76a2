using System.Collections.Generic;

namespace Alate.Files
{
    /// <summary>A list of values of one kind.</summary>
    internal sealed class ListShape : FileShape
    {
        /// <param name="item">Each of them.</param>
        /// <param name="least">The fewest.</param>
        /// <param name="most">The most.</param>
        /// <param name="words">What it is.</param>
        public ListShape(FileShape item, int least, int most, string words)
        {
            Item = item;
            Least = least;
            Most = most;
            Words = words;
        }

        /// <summary>Kind of each value.</summary>
        public FileShape Item { get; }

        /// <summary>Fewest values.</summary>
        public int Least { get; }

        /// <summary>Most values.</summary>
        public int Most { get; }

        public override string Words { get; }

        public override IEnumerable<FileShape> Inner => new[] { Item };

        public override void Check(JsonPlace value)
        {
            if (value.Kind != JsonKind.List)
                throw Not(value);
            if (value.Items.Count < Least || value.Items.Count > Most)
                throw value.Wrong($"it must be {Words}, not {value.Items.Count} values");
            foreach (JsonPlace one in value.Items)
                Item.Check(one);
        }
    }
}
