using System;

namespace Alate.Files
{
    /// <summary>A number of a range, in its unit.</summary>
    internal sealed class NumberShape : FileShape
    {
        private readonly string m_Unit;

        /// <param name="least">The least.</param>
        /// <param name="most">The most.</param>
        /// <param name="unit">In words; empty for a ratio.</param>
        /// <param name="isWhole">True for whole numbers alone.</param>
        public NumberShape(decimal least, decimal most, string unit, bool isWhole = false)
        {
            Least = least;
            Most = most;
            m_Unit = unit;
            IsWhole = isWhole;
        }

        /// <summary>Smallest number that is taken.</summary>
        public decimal Least { get; }

        /// <summary>Largest number that is taken.</summary>
        public decimal Most { get; }

        /// <summary>True for whole numbers alone.</summary>
        public bool IsWhole { get; }

        public override string Words => Least == Most ? FormattableString.Invariant($"{Least}") : FormattableString.Invariant(
            $"a {(IsWhole ? "whole " : "")}number from {Least} to {Most}{(m_Unit.Length == 0 ? "" : $" {m_Unit}")}");

        public override void Check(JsonPlace value)
        {
            if (value.Kind != JsonKind.Number)
                throw Not(value);
            if (!FileNumber.TryRead(value.Text, out decimal number) || number < Least || number > Most
                || IsWhole && number != decimal.Truncate(number))
            {
                string shown = Quote.Of(value.Text);
                throw value.Wrong($"{shown.Substring(1, shown.Length - 2)} is out of range: {Words} is allowed");
            }
        }
    }
}
