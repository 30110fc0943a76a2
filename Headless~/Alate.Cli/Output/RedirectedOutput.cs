using System.IO;
using System.Text;

namespace Alate.Cli.Output;

/// <summary>The standard output where it is a file or a pipe: a full disk becomes a <see cref="UserException"/>.</summary>
internal sealed class RedirectedOutput(TextWriter output) : TextWriter
{
    public override Encoding Encoding => output.Encoding;

    public override void Write(char value) => Write(value.ToString());

    public override void Write(char[] buffer, int index, int count) => Write(new string(buffer, index, count));

    public override void Write(string value)
    {
        try
        {
            output.Write(value);
        }
        catch (IOException problem)
        {
            throw Refused(problem);
        }
    }

    public override void Flush()
    {
        try
        {
            output.Flush();
        }
        catch (IOException problem)
        {
            throw Refused(problem);
        }
    }

    private static UserException Refused(IOException problem) => new($"Cannot write to the standard output: {problem.Message}");
}
