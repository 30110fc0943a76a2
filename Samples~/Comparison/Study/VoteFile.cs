using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Alate.Samples
{
    /// <summary>The votes of all participants, in a CSV file that a table program opens.</summary>
    internal sealed class VoteFile
    {
        private const string k_Header = "time,participant,species,left,right,chosen";
        private const int k_Columns = 6;

        /// <param name="path">Made with the first vote.</param>
        public VoteFile(string path)
        {
            Path = path;
        }

        /// <summary>Path of the file.</summary>
        public string Path { get; }

        /// <summary>Adds a vote, given now.</summary>
        public void Add(in Vote vote)
        {
            Directory.CreateDirectory(System.IO.Path.GetDirectoryName(Path));
            if (!File.Exists(Path))
                File.WriteAllText(Path, k_Header + "\n");
            string now = DateTime.UtcNow.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture);
            File.AppendAllText(Path, $"{now},{vote.Participant},{vote.Species},{vote.Left},{vote.Right},{vote.Chosen}\n");
        }

        /// <summary>Reads all votes; none where there is no file.</summary>
        /// <exception cref="FormatException">A line is not one of this sample's; says which.</exception>
        public List<Vote> Read()
        {
            var votes = new List<Vote>();
            if (!File.Exists(Path))
                return votes;
            string[] lines = File.ReadAllLines(Path);
            for (int line = 1; line < lines.Length; line++)
            {
                string[] values = lines[line].Split(',');
                if (values.Length != k_Columns || (values[5] != values[3] && values[5] != values[4]))
                    throw new FormatException($"{Path}, line {line + 1}: '{lines[line]}' is not a vote ({k_Header}).");
                votes.Add(new Vote(values[1], values[2], values[3], values[4], values[5]));
            }

            return votes;
        }
    }
}
