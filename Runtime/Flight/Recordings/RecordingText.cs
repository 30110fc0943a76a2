using System.Globalization;
using System.Text;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Recordings as text: a line for each thing that changes. A line <c>go</c> is a command and the first step flown by it, <c>fly</c>
    /// the number of further steps without a change. Numbers are written so that the same bits are read.
    /// </summary>
    internal static class RecordingText
    {
        private const string k_Title = "alate flight ", k_Scene = "scene", k_None = "-";

        /// <summary>Names of lines, which writer and reader share.</summary>
        internal const string Package = "package", Insect = "insect", Model = "model", Options = "options", Start = "start", Wing = "wing",
            Step = "step", Wind = "wind", Gravity = "gravity", Aid = "aid", Guard = "guard", Push = "push", Go = "go", Fly = "fly",
            End = "end";

        /// <summary>First words of the file: what it is, without its version.</summary>
        internal static string Title => k_Title;

        /// <summary>Word of a start with wings that begin their beat.</summary>
        internal static string Scene => k_Scene;

        /// <summary>Words for commands that are kept within what the insect flies, as they are at first, or not.</summary>
        internal const string On = "on", Off = "off";

        /// <summary>Word for what is not there.</summary>
        internal static string None => k_None;

        /// <summary>Writes a recording.</summary>
        public static string Write(FlightRecording recording)
        {
            var text = new StringBuilder();
            text.Append(k_Title).Append(FlightRecording.Format).Append('\n');
            Line(text, Package, Word(recording.Package));
            Line(text, Insect, Word(recording.Insect));
            Line(text, Model, recording.KeyText);
            if (recording.Options.Length > 0)
                Line(text, Options, recording.Options.Replace('\n', ' ').Replace('\r', ' '));
            FlightStart start = recording.Start;
            if (start.settled)
                Line(text, Start, $"{Text(start.condition.Speed)} {Text(start.condition.Climb)} {Text(start.heading)}");
            else
                Line(text, Start, $"{k_Scene} {Text(start.phase)} {Text(start.heading)}");
            foreach (RecordedPlace wing in recording.Wings)
                Line(text, Wing, $"{Text(wing.hinge)} {Text(wing.axes.c0)} {Text(wing.axes.c1)} {Text(wing.axes.c2)}");
            WriteSteps(text, recording);
            Line(text, End, recording.Steps.Count.ToString(CultureInfo.InvariantCulture));
            return text.ToString();
        }

        private static void WriteSteps(StringBuilder text, FlightRecording recording)
        {
            var before = new RecordedStep { wind = new float3(float.NaN), gravity = new float3(float.NaN), aid = float.NaN };
            int push = 0, more = 0;
            for (int k = 0; k < recording.Steps.Count; k++)
            {
                RecordedStep step = recording.Steps[k];
                bool pushed = push < recording.Pushes.Count && recording.Pushes[push].step <= k;
                bool commanded = !Same(step.velocity, before.velocity) || !Same(step.heading, before.heading);
                bool changed = step.count != before.count || !Same(step.length, before.length) || !Same(step.wind, before.wind)
                    || !Same(step.gravity, before.gravity) || !Same(step.aid, before.aid) || step.isUnguarded != before.isUnguarded;
                if (k > 0 && !pushed && !commanded && !changed)
                {
                    more++;
                    continue;
                }

                Flush(text, ref more);
                for (; push < recording.Pushes.Count && recording.Pushes[push].step <= k; push++)
                    Line(text, Push, Text(recording.Pushes[push]));
                WriteChanges(text, step, before);
                string heading = float.IsNaN(step.heading) ? k_None : Text(step.heading);
                if (k == 0 || commanded)
                    Line(text, Go, $"{Text(step.velocity)} {heading}");
                else
                    more = 1;
                before = step;
            }

            Flush(text, ref more);
        }

        private static void WriteChanges(StringBuilder text, in RecordedStep step, in RecordedStep before)
        {
            if (!Same(step.length, before.length) || step.count != before.count)
                Line(text, Step, Text(step.length) + (step.count == 1 ? "" : $" {step.count}"));
            if (!Same(step.wind, before.wind))
                Line(text, Wind, Text(step.wind));
            if (!Same(step.gravity, before.gravity))
                Line(text, Gravity, Text(step.gravity));
            if (!Same(step.aid, before.aid))
                Line(text, Aid, Text(step.aid));
            if (step.isUnguarded != before.isUnguarded)
                Line(text, Guard, step.isUnguarded ? Off : On);
        }

        private static void Flush(StringBuilder text, ref int more)
        {
            if (more > 0)
                Line(text, Fly, more.ToString(CultureInfo.InvariantCulture));
            more = 0;
        }

        private static void Line(StringBuilder text, string name, string value) => text.Append(name).Append(' ').Append(value).Append('\n');

        private static string Word(string value) => string.IsNullOrWhiteSpace(value) ? k_None : value.Trim().Replace(' ', '-');

        private static string Text(in RecordedPush push) =>
            $"{Text(push.rotation.value.xyz)} {Text(push.rotation.value.w)} {Text(push.velocity)} {Text(push.spin)} {Text(push.turn)}";

        private static string Text(float3 value) => $"{Text(value.x)} {Text(value.y)} {Text(value.z)}";

        // The fewest digits that are read as the same number.
        private static string Text(float value) => value.ToString("R", CultureInfo.InvariantCulture);

        // The sign of a zero counts, and a number that is none is equal to itself.
        private static bool Same(float a, float b) => math.asuint(a) == math.asuint(b) || float.IsNaN(a) && float.IsNaN(b);

        private static bool Same(float3 a, float3 b) => Same(a.x, b.x) && Same(a.y, b.y) && Same(a.z, b.z);
    }
}
