namespace Engraver.Simulator;

/// <summary>Writes the collected rows to the record's file. When writing fails, the controller continues without the file.</summary>
internal sealed class RecordFile(MotionRecord record)
{
    /// <summary>The error that stopped the writing; null while writing succeeds.</summary>
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

    /// <summary>Writes the pending rows and closes the file.</summary>
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
