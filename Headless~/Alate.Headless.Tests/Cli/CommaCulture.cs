using System;
using System.Globalization;

namespace Alate.Tests.Cli
{
    /// <summary>Makes this thread write numbers as much of Europe does, 1.234,5, until it is disposed.</summary>
    internal sealed class CommaCulture : IDisposable
    {
        private readonly CultureInfo m_Before = CultureInfo.CurrentCulture;

        public CommaCulture()
        {
            var commas = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            commas.NumberFormat.NumberDecimalSeparator = ",";
            commas.NumberFormat.NumberGroupSeparator = ".";
            commas.NumberFormat.NegativeSign = "−";
            CultureInfo.CurrentCulture = commas;
        }

        public void Dispose() => CultureInfo.CurrentCulture = m_Before;
    }
}
