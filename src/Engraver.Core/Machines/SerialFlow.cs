namespace Engraver.Core.Machines;

/// <summary>Flow control of a serial line.</summary>
public enum SerialFlow : byte
{
    /// <summary>The lines RTS and CTS, which the controller expects; without them characters are lost in bursts (galil-dmc.md A.2).</summary>
    RtsCts,

    /// <summary>None, for a three-wire cable.</summary>
    None,

    /// <summary>The characters Ctrl-S and Ctrl-Q. This damages binary records (QR).</summary>
    XonXoff,
}
