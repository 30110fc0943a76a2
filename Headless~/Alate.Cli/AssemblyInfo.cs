using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Tests")]
