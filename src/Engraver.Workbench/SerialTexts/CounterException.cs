using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.SerialTexts;

/// <summary>The counters do not give a number. Nothing was engraved.</summary>
public sealed class CounterException : Exception
{
    public CounterException()
    {
    }

    public CounterException(string message)
        : base(message)
    {
    }

    public CounterException(string message, Exception inner)
        : base(message, inner)
    {
    }

    public CounterException(Diagnostic finding)
        : base(finding?.Message) => Finding = finding;

    /// <summary>What happened, and what to do.</summary>
    public Diagnostic? Finding { get; }
}
