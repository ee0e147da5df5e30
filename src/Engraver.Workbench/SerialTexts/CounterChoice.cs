namespace Engraver.Workbench.SerialTexts;

/// <summary>Which number a plate gets after a plate of the same counter that was started and not finished.</summary>
public enum CounterChoice : byte
{
    /// <summary>Not decided: no plate is started.</summary>
    Ask,

    /// <summary>The number of the unfinished plate.</summary>
    Again,

    /// <summary>The next number; that of the unfinished plate is left out.</summary>
    Next,
}
