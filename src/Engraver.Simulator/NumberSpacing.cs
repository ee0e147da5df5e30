namespace Engraver.Simulator;

/// <summary>What divides two numbers of one message (galil-dmc.md A.3).</summary>
public enum NumberSpacing
{
    /// <summary>A blank, whatever the sign of the second: <c>20000.0000 -81.0000</c>.</summary>
    Blank,

    /// <summary>The column of the sign and nothing else, so that a minus follows the last digit: <c>20000.0000-81.0000</c>.</summary>
    SignColumn,
}
