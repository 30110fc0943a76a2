using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Unity.Editor")]
[assembly: InternalsVisibleTo("Unity.TestFramework")]
