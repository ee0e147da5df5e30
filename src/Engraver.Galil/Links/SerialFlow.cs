namespace Engraver.Galil.Links;

/// <summary>How the two ends of a serial line hold each other back.</summary>
public enum SerialFlow : byte
{
    /// <summary>The lines RTS and CTS: what the controller expects; without it characters are lost in bursts (galil-dmc.md A.2).</summary>
    RtsCts,

    /// <summary>Nothing: a cable of three wires.</summary>
    None,

    /// <summary>The characters Ctrl-S and Ctrl-Q. Binary records (QR) do not survive it.</summary>
    XonXoff,
}
