namespace Engraver.Galil.Tests.Links;

/// <summary>When a controller echoes a line that it receives while it still answers another: unknown for the real one (galil-dmc.md A.2).</summary>
public enum EchoTime
{
    BehindTheAnswer,
    BeforeTheAnswer,
    AmidTheAnswer,
}
