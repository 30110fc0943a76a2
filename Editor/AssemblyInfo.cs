using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Editor.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
[assembly: InternalsVisibleTo("Alate.Cli")]
