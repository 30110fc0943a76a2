namespace StandIns;

/// <summary>The program that this process takes for the editor, and the code with which it was asked to end.</summary>
public static class RunningEditor
{
    /// <summary>Path of the program.</summary>
    public static string Path { get; set; } = "";

    /// <summary>Folder of its data.</summary>
    public static string Contents { get; set; } = "";

    /// <summary>Code of <c>EditorApplication.Exit</c>; null before it is called.</summary>
    public static int? ExitCode { get; set; }
}
