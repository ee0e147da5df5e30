using Avalonia.Input.Raw;

namespace Engraver.SoftwarePlatform.X11;

/// <summary>The two that a drag stands between: the program that drags, and the window below.</summary>
internal interface IXdndPartner
{
    /// <summary>Asks the source for the files; the answer comes through <see cref="XdndSession.FilesArrived"/>.</summary>
    void RequestFiles(nint time);

    /// <summary>Tells the window; its answer comes through <see cref="XdndSession.Answer"/>. The place is in pixels of the root window.</summary>
    void Tell(RawDragEventType type, int rootX, int rootY, IReadOnlyList<string> files);

    void SendStatus(nint source, bool accepted);

    void SendFinished(nint source, bool accepted);
}
