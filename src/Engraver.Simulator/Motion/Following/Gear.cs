namespace Engraver.Simulator.Motion.Following;

/// <summary>GA, GR and GM of one axis (galil-dmc.md B.6): it follows another axis, or the path length of a plane, which only grows.</summary>
internal sealed class Gear
{
    private double _masterBefore;

    /// <summary>Letter of the master: A to D, N, M, S or T; blank when there is none.</summary>
    public char Master { get; set; } = ' ';

    /// <summary>GR: counts of this axis for one count of the master; 0 ends gearing.</summary>
    public double Ratio { get; private set; }

    /// <summary>GM 1: neither ST nor a limit ends gearing.</summary>
    public bool IsGantry { get; set; }

    public bool IsEngaged => Ratio != 0 && Master != ' ';

    public void Engage(double ratio, double masterNow)
    {
        Ratio = ratio;
        _masterBefore = masterNow;
    }

    /// <summary>Ends gearing for ST or a limit, unless GM 1 was given.</summary>
    public void Release() => Ratio = IsGantry ? Ratio : 0;

    /// <summary>Called when the master's position has been redefined without motion.</summary>
    public void Renumber(double difference) => _masterBefore += difference;

    /// <summary>The master has moved since the last <see cref="Follow"/>.</summary>
    public bool IsBehind(double masterNow) => masterNow != _masterBefore;

    /// <summary>Counts that this axis must move for the master's motion since the last call.</summary>
    public double Follow(double masterNow)
    {
        var counts = Ratio * (masterNow - _masterBefore);
        _masterBefore = masterNow;
        return counts;
    }
}
