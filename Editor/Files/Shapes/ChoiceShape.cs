using System;
using System.Collections.Generic;

namespace Alate.Files
{
    /// <summary>One of some words, or true and false.</summary>
    internal sealed class ChoiceShape : FileShape
    {
        private readonly string[] m_Choices;

        /// <param name="choices">The words; none for true and false.</param>
        public ChoiceShape(params string[] choices)
        {
            m_Choices = choices;
        }

        /// <summary>The words; none for true and false.</summary>
        public IReadOnlyList<string> Choices => m_Choices;

        public override string Words => m_Choices.Length == 0 ? "true or false" : $"one of {string.Join(", ", m_Choices)}";

        public override void Check(JsonPlace value)
        {
            bool isOne = m_Choices.Length == 0
                ? value.Kind == JsonKind.True || value.Kind == JsonKind.False
                : value.Kind == JsonKind.Text && Array.IndexOf(m_Choices, value.Text) >= 0;
            if (!isOne)
                throw Not(value);
        }
    }
}
