using System;
using System.IO;
using System.Threading;
using UnityEditor;

namespace Alate.Proof
{
    /// <summary>
    /// A proof from the command line: <c>-executeMethod Alate.Proof.ProofCommand.Run -proofOut DIR -proofPackage DIR -proofPipelines
    /// builtin,urp</c>. The editor ends with 0 where no line differs, with 1 where one does, and with 2 where the proof cannot start.
    /// </summary>
    internal static class ProofCommand
    {
        private const int k_Milliseconds = 200;

        /// <summary>Proves, and ends the editor.</summary>
        public static void Run() => EditorApplication.Exit(Prove(Environment.GetCommandLineArgs(), Console.Out));

        private static int Prove(string[] arguments, TextWriter output)
        {
            ProofOptions options = OptionsOf(arguments);
            string problem = options.FindProblem();
            if (problem != null)
            {
                Directory.CreateDirectory(options.Out);
                File.WriteAllText(Path.Combine(options.Out, "problem.txt"), problem + "\n");
                return 2;
            }

            using (var campaign = new ProofCampaign(options))
            {
                string told = null;
                while (campaign.Advance())
                {
                    if (campaign.Status != told)
                        output.WriteLine(told = campaign.Status);
                    Thread.Sleep(k_Milliseconds);
                }

                return campaign.Report.Count(ProofState.Differs) == 0 ? 0 : 1;
            }
        }

        private static ProofOptions OptionsOf(string[] arguments) => new ProofOptions
        {
            Editor = ProofOptions.ProgramOf(EditorApplication.applicationPath),
            Contents = EditorApplication.applicationContentsPath,
            Package = Path.GetFullPath(ProofArguments.Value(ProofArguments.Package)),
            Version = PackageFile.VersionIn(ProofArguments.Value(ProofArguments.Package)) ?? "",
            Out = Path.GetFullPath(ProofArguments.Value(ProofArguments.Out)),
            Pipelines = (ProofArguments.Find(arguments, ProofArguments.Pipelines) ?? ProofPipelines.BuiltIn).Split(','),
        };
    }
}
