using System;
using System.Globalization;
using System.IO;
using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Reads recordings line by line; an error names the line.</summary>
    internal sealed class RecordingReader
    {
        /// <summary>Longest step of the wings, seconds, and most of them at once.</summary>
        private const float k_MostLength = 1f, k_MostCount = 1000;

        private readonly TextReader m_Text;
        private readonly FlightRecording m_Recording = new FlightRecording();
        private RecordedStep m_Now;
        private int m_Line;
        private bool m_HasModel, m_HasStart, m_HasStep, m_HasCommand;

        private RecordingReader(TextReader text) => m_Text = text;

        /// <summary>Reads a recording.</summary>
        /// <exception cref="FormatException">It is none, of another format, cut, or wrong; one line.</exception>
        public static FlightRecording Read(TextReader text) => new RecordingReader(text).Read();

        private FlightRecording Read()
        {
            string first = Next() ?? "";
            if (!first.StartsWith(RecordingText.Title, StringComparison.Ordinal))
            {
                throw new FormatException(
                    "It is no recording of a flight: its first line is not '" + RecordingText.Title + FlightRecording.Format + "'.");
            }
            if (first.Substring(RecordingText.Title.Length) != FlightRecording.Format.ToString(CultureInfo.InvariantCulture))
            {
                throw new FormatException(
                    $"It is a recording of another version, '{Short(first)}'; this one reads {FlightRecording.Format}.");
            }
            for (string line = Next(); line != null; line = Next())
            {
                int space = line.IndexOf(' ');
                string name = space < 0 ? line : line.Substring(0, space), value = space < 0 ? "" : line.Substring(space + 1);
                if (name == RecordingText.End)
                    return Ended(value);
                try
                {
                    SetField(name, value);
                }
                catch (FormatException) when (m_Text.Peek() < 0)
                {
                    throw Cut();
                }
            }

            throw Cut();
        }

        private FlightRecording Ended(string value)
        {
            if (!int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int count) || count != m_Recording.Steps.Count)
                throw Wrong($"there are {m_Recording.Steps.Count} steps");
            for (string line = Next(); line != null; line = Next())
            {
                if (line.Length > 0)
                    throw Wrong("nothing follows the end");
            }

            if (!m_HasModel || !m_HasStart || count == 0)
                throw new FormatException(!m_HasModel || !m_HasStart ? "It does not say which insect starts how." : "It has no step.");
            return m_Recording;
        }

        private string Next()
        {
            m_Line++;
            return m_Text.ReadLine();
        }

        private void SetField(string name, string value)
        {
            switch (name)
            {
                case RecordingText.Package: m_Recording.Package = value == RecordingText.None ? "" : value; break;
                case RecordingText.Insect: m_Recording.Insect = value == RecordingText.None ? "" : value; break;
                case RecordingText.Options: m_Recording.Options = value; break;
                case RecordingText.Model: TakeModel(value); break;
                case RecordingText.Start: TakeStart(value); break;
                case RecordingText.Wing: TakeWing(value); break;
                case RecordingText.Step: TakeStep(value); break;
                case RecordingText.Wind: m_Now.wind = Vector(Numbers(value, 3), 0); break;
                case RecordingText.Gravity: m_Now.gravity = Vector(Numbers(value, 3), 0); break;
                case RecordingText.Aid: m_Now.aid = Numbers(value, 1)[0]; break;
                case RecordingText.Guard: TakeGuard(value); break;
                case RecordingText.Push: TakePush(value); break;
                case RecordingText.Go: TakeCommand(value); break;
                case RecordingText.Fly: TakeMore(value); break;
                default: throw Wrong($"'{Short(name)}' is no line of a recording");
            }
        }

        private void TakeModel(string value)
        {
            if (!uint.TryParse(value, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint key))
                throw Wrong($"'{Short(value)}' is no key of a model");
            m_Recording.Key = key;
            m_HasModel = true;
        }

        private void TakeStart(string value)
        {
            bool scene = value.StartsWith(RecordingText.Scene + " ", StringComparison.Ordinal);
            float[] numbers = Numbers(scene ? value.Substring(RecordingText.Scene.Length + 1) : value, scene ? 2 : 3);
            m_Recording.Start = scene
                ? new FlightStart { phase = numbers[0], heading = numbers[1] }
                : new FlightStart { settled = true, condition = new FlightCondition(numbers[0], numbers[1]), heading = numbers[2] };
            m_HasStart = true;
        }

        private void TakeWing(string value)
        {
            float[] numbers = Numbers(value, 12);
            m_Recording.Wings.Add(new RecordedPlace
            {
                hinge = Vector(numbers, 0),
                axes = new float3x3(Vector(numbers, 3), Vector(numbers, 6), Vector(numbers, 9)),
            });
        }

        private void TakeStep(string value)
        {
            float[] numbers = Numbers(value, value.IndexOf(' ') < 0 ? 1 : 2);
            float count = numbers.Length > 1 ? numbers[1] : 1f;
            if (!(numbers[0] > 0f) || numbers[0] > k_MostLength || !(count >= 1f) || count > k_MostCount || count != math.floor(count))
                throw Wrong($"a step needs up to {k_MostLength} s and a whole number of times from 1 to {k_MostCount}");
            m_Now.length = numbers[0];
            m_Now.count = (int)count;
            m_HasStep = true;
        }

        private void TakeGuard(string value)
        {
            if (value != RecordingText.On && value != RecordingText.Off)
                throw Wrong($"'{Short(value)}' is neither {RecordingText.On} nor {RecordingText.Off}");
            m_Now.isUnguarded = value == RecordingText.Off;
        }

        private void TakePush(string value)
        {
            float[] numbers = Numbers(value, 11);
            m_Recording.Pushes.Add(new RecordedPush
            {
                step = m_Recording.Steps.Count,
                rotation = new quaternion(new float4(Vector(numbers, 0), numbers[3])),
                velocity = Vector(numbers, 4),
                spin = Vector(numbers, 7),
                turn = numbers[10],
            });
        }

        private void TakeCommand(string value)
        {
            bool follows = value.EndsWith(" " + RecordingText.None, StringComparison.Ordinal);
            float[] numbers = Numbers(follows ? value.Substring(0, value.Length - 2) : value, follows ? 3 : 4);
            m_Now.velocity = Vector(numbers, 0);
            m_Now.heading = follows ? float.NaN : numbers[3];
            m_HasCommand = true;
            Add(1);
        }

        private void TakeMore(string value)
        {
            if (!int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int count) || count < 1)
                throw Wrong($"'{Short(value)}' is no number of steps");
            if (!m_HasCommand)
                throw Wrong("steps need a command before them");
            Add(count);
        }

        private void Add(int count)
        {
            if (!m_HasStep)
                throw Wrong("a command needs the length of a step before it");
            if (count > FlightRecording.MostSteps - m_Recording.Steps.Count)
                throw Wrong($"a recording has at most {FlightRecording.MostSteps} steps");
            for (int k = 0; k < count; k++)
                m_Recording.Steps.Add(m_Now);
        }

        private float[] Numbers(string value, int count)
        {
            string[] words = value.Split(' ');
            float[] numbers = new float[words.Length];
            for (int k = 0; k < words.Length; k++)
            {
                if (words.Length != count || !float.TryParse(words[k], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[k])
                    || !math.isfinite(numbers[k]))
                {
                    throw Wrong(count == 1 ? $"'{Short(value)}' is not a number" : $"'{Short(value)}' are not {count} numbers");
                }
            }

            return numbers;
        }

        private static float3 Vector(float[] numbers, int from) => new float3(numbers[from], numbers[from + 1], numbers[from + 2]);

        private FormatException Cut() =>
            new FormatException($"It is cut off at line {m_Line}: the last line of a recording is '{RecordingText.End}'.");

        private FormatException Wrong(string why) => new FormatException($"Line {m_Line}: {why}.");

        private static string Short(string text) => text.Length <= 60 ? text : text.Substring(0, 60) + "…";
    }
}
