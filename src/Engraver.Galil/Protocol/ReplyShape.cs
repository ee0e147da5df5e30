namespace Engraver.Galil.Protocol;

/// <summary>How the reply to a command is framed.</summary>
public enum ReplyShape
{
    /// <summary>Data lines, CR LF, prompt; or the prompt alone.</summary>
    Text,

    /// <summary>UL and QU: text ended by Ctrl-Z (or a backslash), then the prompt (galil-dmc.md A.6).</summary>
    Upload,

    /// <summary>QR: a binary record of known length, then the prompt (galil-dmc.md A.9).</summary>
    Record,

    /// <summary>The first words on a serial line (<see cref="SerialGreeting"/>): whatever comes, up to the answer to the last of them.</summary>
    Greeting,
}
