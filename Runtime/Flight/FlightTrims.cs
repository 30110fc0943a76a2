using System.Collections.Generic;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Asset with the trim table of one kind of insect, made by <see cref="TrimBake"/>; flights of other numbers do not take it.
    /// </summary>
    public sealed class FlightTrims : ScriptableObject
    {
        [SerializeField]
        [HideInInspector]
        private string m_Text;

        private static readonly Dictionary<(string, uint), Shared> s_Shared = new Dictionary<(string, uint), Shared>();

        /// <summary>Makes an asset of a table.</summary>
        /// <param name="table">The table.</param>
        /// <param name="model">The insect that it was made for.</param>
        public static FlightTrims Create(TrimTable table, FlightModel model) => Create(TrimTableText.Write(table, model.Key));

        internal static FlightTrims Create(string text)
        {
            FlightTrims made = CreateInstance<FlightTrims>();
            made.m_Text = text;
            return made;
        }

        /// <summary>The table for an insect, shared by all that use it; null where this is not its table.</summary>
        internal TrimTable Open(uint key)
        {
            if (!s_Shared.TryGetValue((m_Text ?? "", key), out Shared shared))
            {
                TrimTable table = TrimTableText.Read(m_Text, key);
                if (table == null)
                    return null;
                s_Shared.Add((m_Text, key), shared = new Shared { table = table });
            }

            shared.users++;
            return shared.table;
        }

        /// <summary>Gives a table back; the last one frees it.</summary>
        internal static void Return(TrimTable table)
        {
            foreach (KeyValuePair<(string, uint), Shared> entry in s_Shared)
            {
                if (!ReferenceEquals(entry.Value.table, table))
                    continue;
                if (--entry.Value.users == 0)
                {
                    table.Dispose();
                    s_Shared.Remove(entry.Key);
                }

                return;
            }
        }

        private sealed class Shared
        {
            public TrimTable table;
            public int users;
        }
    }
}
