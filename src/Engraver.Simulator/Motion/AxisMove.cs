namespace Engraver.Simulator.Motion;

/// <summary>What the next BG of an axis means: the last of PA, PR, JG, HM, FE and FI given.</summary>
internal enum AxisMove
{
    Relative,
    Absolute,
    Jog,

    /// <summary>PT: the target may change at any time (galil-dmc.md C).</summary>
    Tracking,
    Home,
    FindEdge,
    FindIndex,
}
