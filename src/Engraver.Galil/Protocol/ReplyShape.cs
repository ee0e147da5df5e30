namespace Engraver.Galil.Protocol;

/// <summary>Shapes of replies.</summary>
public enum ReplyShape
{
    /// <summary>Data lines, CR LF, prompt; or the prompt alone.</summary>
    Text,

    /// <summary>UL and QU: text ended by Ctrl-Z (or a backslash), then the prompt (galil-dmc.md A.6).</summary>
    Upload,

    /// <summary>QR: a binary record of known length, then the prompt (galil-dmc.md A.9).</summary>
    Record,

    /// <summary>The reply to the first lines on a serial line (<see cref="EchoHandshake"/>): anything up to the reply to the last of them.</summary>
    Greeting,
}
