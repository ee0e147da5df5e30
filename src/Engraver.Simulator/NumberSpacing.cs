namespace Engraver.Simulator;

/// <summary>Separator of two numbers of one message (galil-dmc.md A.3).</summary>
public enum NumberSpacing
{
    /// <summary>A blank, independent of the sign of the second number: <c>20000.0000 -81.0000</c>.</summary>
    Blank,

    /// <summary>Only the column of the sign, so that a minus follows the last digit directly: <c>20000.0000-81.0000</c>.</summary>
    SignColumn,
}
