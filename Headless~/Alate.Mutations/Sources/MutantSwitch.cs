using System.Text.RegularExpressions;

namespace Alate.Mutations.Sources;

/// <summary>The class, one in each changed assembly, that says which mutant lives in this process.</summary>
internal static class MutantSwitch
{
    /// <summary>Variable of the environment with the number of the mutant; none, or 0, is the program as it stands.</summary>
    public const string Variable = "ALATE_MUTANT";

    /// <summary>Variable with the file to which a process that ends adds the numbers of mutants that it met; set to record.</summary>
    public const string HitsVariable = "ALATE_MUTANT_HITS";

    /// <summary>First part of the class's name; the second is the assembly's.</summary>
    public const string Prefix = "AlateMutants_";

    public static string Name(string assembly) => Prefix + Regex.Replace(assembly, "[^A-Za-z0-9]", "_");

    /// <summary>Source of the class. Fields are initialised before methods of the assembly are compiled, which then fold them.</summary>
    public static string Source(string assembly, int count) => $$"""
        using System;
        internal static class {{Name(assembly)}}
        {
            private static readonly int s_Active = int.TryParse(Environment.GetEnvironmentVariable("{{Variable}}"), out int n) ? n : 0;
            private static readonly string s_File = Environment.GetEnvironmentVariable("{{HitsVariable}}");
            public static readonly byte[] Hits = s_File == null ? null : new byte[{{count + 1}}];
            /// <summary>Mutants whose first place was met while a value was made that is kept: no other test meets it.</summary>
            public static readonly bool[] Once = s_File == null ? null : new bool[{{count + 1}}];
            private static readonly bool[] s_Met = s_File == null ? null : new bool[{{count + 1}}];
            public static bool Is(int mutant)
            {
                if (Hits != null && Hits[mutant] == 0)
                    Meet(mutant);
                return mutant == s_Active;
            }
            private static void Meet(int mutant)
            {
                Hits[mutant] = 1;
                if (s_Met[mutant])
                    return;
                s_Met[mutant] = true;
                foreach (System.Diagnostics.StackFrame frame in new System.Diagnostics.StackTrace().GetFrames())
                {
                    System.Reflection.MethodBase method = frame.GetMethod();
                    string type = method?.DeclaringType?.FullName ?? "";
                    Once[mutant] |= method?.Name == ".cctor" || type.StartsWith("System.Lazy", StringComparison.Ordinal);
                }
            }
            [System.Runtime.CompilerServices.ModuleInitializer]
            internal static void Begin()
            {
                if (Hits == null)
                    return;
                AppDomain.CurrentDomain.ProcessExit += (_, _) =>
                {
                    string hits = "";
                    for (int i = 0; i < Hits.Length; i++)
                        hits += Hits[i] != 0 ? i + "\n" : "";
                    System.IO.File.AppendAllText(s_File, hits);
                };
            }
        }
        """;
}
