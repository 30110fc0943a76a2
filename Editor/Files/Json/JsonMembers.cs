using System.Collections.Generic;

namespace Alate.Files
{
    /// <summary>Members of a JSON object that is written.</summary>
    internal sealed class JsonMembers
    {
        private readonly List<(string, JsonPlace)> m_All = new List<(string, JsonPlace)>();

        /// <summary>Number of members.</summary>
        public int Count => m_All.Count;

        /// <summary>Adds a member; none where there is no value.</summary>
        public void Add(string key, JsonPlace value)
        {
            if (value != null)
                m_All.Add((key, value));
        }

        /// <summary>Adds members of another object, those that it has.</summary>
        public void Copy(JsonPlace from, params string[] keys)
        {
            foreach (string key in keys)
                Add(key, from?[key]);
        }

        /// <summary>The object.</summary>
        public JsonPlace ToPlace() => new JsonPlace(JsonKind.Object, "", 0, null, m_All);
    }
}
