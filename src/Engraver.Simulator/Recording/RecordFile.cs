namespace Engraver.Simulator;

/// <summary>Writes the gathered rows to the record's file. When writing fails, the controller goes on without the file.</summary>
internal sealed class RecordFile(MotionRecord record)
{
    /// <summary>The error that ended the writing; null while it works.</summary>
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
            Complete();
        }
    }

    /// <summary>Writes the rows that wait and closes the file.</summary>
    public void Complete()
    {
        try
        {
            record.CompleteCsv();
        }
        catch (IOException failure)
        {
            Failure ??= failure;
        }
    }
}
