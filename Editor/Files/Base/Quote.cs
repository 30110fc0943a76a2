namespace Alate.Files
{
    /// <summary>Quotes values of users in messages: as much of them as finds the place.</summary>
    internal static class Quote
    {
        private const int k_Value = 60;

        /// <summary>A value in quotation marks, up to 60 characters.</summary>
        public static string Of(string value) => $"'{Short(value, k_Value)}'";

        /// <summary>The beginning of a text, with an ellipsis where it goes on; never half a character.</summary>
        /// <param name="text">The text.</param>
        /// <param name="most">Most characters.</param>
        public static string Short(string text, int most)
        {
            if (text.Length <= most)
                return text;
            int end = char.IsHighSurrogate(text[most - 1]) ? most - 1 : most;
            return text.Substring(0, end) + "…";
        }
    }
}
