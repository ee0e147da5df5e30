namespace Engraver.Simulator.Motion;

/// <summary>The move that the next BG of an axis starts: the last given of PA, PR, JG, HM, FE and FI.</summary>
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
