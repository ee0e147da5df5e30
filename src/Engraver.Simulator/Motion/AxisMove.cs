namespace Engraver.Simulator.Motion;

/// <summary>What the next BG of an axis means: the last of PA, PR and JG given.</summary>
internal enum AxisMove
{
    Relative,
    Absolute,
    Jog,
}
