namespace Alate
{
    /// <summary>Where one number of a species comes from.</summary>
    public readonly struct SpeciesSource
    {
        /// <summary>Notes a number and its source.</summary>
        public SpeciesSource(string quantity, string value, string source)
        {
            Quantity = quantity;
            Value = value;
            Source = source;
        }

        /// <summary>What the number is, such as "wing length".</summary>
        public string Quantity { get; }

        /// <summary>The number with its unit.</summary>
        public string Value { get; }

        /// <summary>The table, the paper, the measurement, or "assumed" with the reason.</summary>
        public string Source { get; }

        /// <summary>All three in one line.</summary>
        public override string ToString() => $"{Quantity}: {Value} ({Source})";
    }
}
