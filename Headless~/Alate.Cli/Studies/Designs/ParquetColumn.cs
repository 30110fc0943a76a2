using System.Threading.Tasks;
using Parquet;
using Parquet.Schema;

namespace Alate.Cli;

/// <summary>A column of a Parquet file.</summary>
/// <param name="Field">Name and type.</param>
/// <param name="Write">Writes its values.</param>
internal sealed record ParquetColumn(DataField Field, Func<ParquetRowGroupWriter, Task> Write)
{
    /// <summary>A column of numbers or truths.</summary>
    public static ParquetColumn Of<T>(string name, IEnumerable<T> values) where T : struct
    {
        var field = new DataField<T>(name);
        ReadOnlyMemory<T> all = values.ToArray();
        return new ParquetColumn(field, group => group.WriteAsync(field, all));
    }

    /// <summary>A column of texts.</summary>
    public static ParquetColumn OfTexts(string name, IEnumerable<string> values)
    {
        var field = new DataField<string>(name);
        string[] all = values.ToArray();
        return new ParquetColumn(field, group => group.WriteAsync(field, all));
    }
}
