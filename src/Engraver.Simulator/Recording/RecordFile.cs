namespace Engraver.Simulator;

/// <summary>Writes what the record has gathered to its file, until the file takes no more; the controller goes on without it.</summary>
internal sealed class RecordFile(MotionRecord record)
{
    /// <summary>What stopped it from being written; null while all is well.</summary>
    public IOException? Failure { get; private set; }

    public void Flush()
    {
        try
        {
            if (Failure is null) record.FlushCsv();
        }
        catch (IOException failure)
        {
            Failure = failure;
            record.DetachCsv();
        }
    }
}
