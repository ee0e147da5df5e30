using Engraver.Links.Recording;

namespace Engraver.Workbench.Composition;

/// <summary>The recorded conversation with a machine, for a replay.</summary>
public sealed class MachineConversation
{
    internal MachineConversation(ConversationRecorder recorder) => Recorder = recorder;

    internal ConversationRecorder Recorder { get; }

    /// <summary>Why the recording is incomplete; null if complete.</summary>
    public string? Failure => Recorder.Failure;

    /// <summary>Flushes and closes the file.</summary>
    public Task CloseAsync(CancellationToken cancellation) => Recorder.CloseAsync(cancellation);
}
