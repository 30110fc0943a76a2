namespace Unity.Jobs;

/// <summary>A struct whose Execute runs once for each index.</summary>
public interface IJobFor
{
    void Execute(int index);
}
