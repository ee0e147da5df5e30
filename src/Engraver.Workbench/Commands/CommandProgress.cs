namespace Engraver.Workbench.Commands;

/// <summary>Progress of a long command. Any thread.</summary>
public sealed class CommandProgress : IProgress<double>
{
    private const double None = -1.0;
    private double _fraction = None;

    /// <summary>Raised with each report and at the end, on the thread of the command.</summary>
    public event EventHandler? Changed;

    /// <summary>0 to 1; null while no command reports.</summary>
    public double? Fraction => Volatile.Read(ref _fraction) is >= 0.0 and var known ? known : null;

    public void Report(double value) => Set(Math.Clamp(value, 0.0, 1.0));

    /// <summary>Ends the report.</summary>
    public void End()
    {
        if (Fraction is not null) Set(None);
    }

    private void Set(double fraction)
    {
        Volatile.Write(ref _fraction, fraction);
        Changed?.Invoke(this, EventArgs.Empty);
    }
}
