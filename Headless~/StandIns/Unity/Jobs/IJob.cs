namespace Unity.Jobs;

/// <summary>A struct whose Execute runs once, on a worker or in Complete.</summary>
public interface IJob
{
    void Execute();
}
