namespace Alate.Cli;

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
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ObjectDisposedException)
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
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            throw Refused(problem);
        }
    }

    // One that the shell has closed is told as a file without permission.
    private static UserException Refused(Exception problem) =>
        new($"Cannot write to the standard output: {(problem is IOException ? problem.Message : "it is closed.")}");
}
