using System.Globalization;

namespace Alate.Files
{
    /// <summary>
    /// Numbers of a file in its units, and in those of the presets: a power of ten between the two moves the decimal point, so that what is
    /// written and read again has the same bits.
    /// </summary>
    internal static class FileNumber
    {
        private const NumberStyles k_Style = NumberStyles.Float;

        /// <summary>Reads a number as it is written; false where it is beyond what any key takes.</summary>
        public static bool TryRead(string text, out decimal number) =>
            decimal.TryParse(text, k_Style, CultureInfo.InvariantCulture, out number);

        /// <summary>A number of a file in the unit of a preset.</summary>
        /// <param name="text">As it is written; checked.</param>
        /// <param name="perUnit">The file's units of one of the preset's, a power of ten.</param>
        public static float ToPreset(string text, decimal perUnit)
        {
            TryRead(text, out decimal number);
            return float.Parse((number / perUnit).ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        }

        /// <summary>A number of a preset in the unit of a file, without zeros behind it.</summary>
        public static decimal ToFile(float value, decimal perUnit)
        {
            // A division by one with many digits strips the zeros.
            const decimal k_One = 1.000000000000000000000000000m;
            string shortest = value.ToString("R", CultureInfo.InvariantCulture);
            return decimal.Parse(shortest, k_Style, CultureInfo.InvariantCulture) * perUnit / k_One;
        }
    }
}
