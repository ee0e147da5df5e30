using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs;

/// <summary>What became of a line of segments.</summary>
/// <param name="Reply">The reply to the line, or to the heartbeat before it.</param>
/// <param name="Accepted">Segments that are in the buffer, from the first of the line.</param>
/// <param name="Sent">Segments of the line.</param>
/// <param name="Bytes">Bytes of the line and its prompts.</param>
internal readonly record struct SentSegments(Reply Reply, int Accepted, int Sent, int Bytes)
{
    /// <summary>Bytes of CR and prompt.</summary>
    private const int FrameBytes = 2;

    public static SentSegments One(Reply reply, string segment) => new(reply, reply is Accepted ? 1 : 0, 1, segment.Length + FrameBytes);
}
