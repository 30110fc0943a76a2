using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Proof")]
[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
