namespace Engraver.Simulator.Protocol;

/// <summary>Services of the controller for a handle: execution of its commands and accounting of their time.</summary>
internal interface ICommandSink
{
    /// <summary>Called when a command is complete, before it is executed: its decode time passes. In real time the command is then deferred.</summary>
    /// <returns>True when the handle must wait for <see cref="Handle.Resume"/>.</returns>
    bool DefersCommand(Handle handle);

    /// <summary>Executes one command; returns the reply with its prompt, valid until the next command, or an empty reply when no answer is sent.</summary>
    ReadOnlySpan<char> Execute(Handle handle, ReadOnlySpan<char> text);

    /// <summary>Refuses text that is not a command, for example a line that is too long.</summary>
    string? Refuse(Handle handle, int code);

    /// <summary>Takes one line of a download; returns false when it is invalid.</summary>
    bool StoreLine(string line);

    string? EndDownload(bool failed);

    string? StoreArray(Handle handle, Action store);

    /// <summary>Called for every byte received: on the serial line it takes its transmission time, is echoed and can interrupt the program.</summary>
    /// <returns>False when it is data for the program and not part of a command (CI).</returns>
    bool ByteReceived(Handle handle, byte value);

    /// <summary>Called when the reply has been sent: advances time.</summary>
    void ReplySent(Handle handle, int replyLength);

    /// <summary>Sends bytes to the client of a handle.</summary>
    void Deliver(Handle handle, ReadOnlySpan<byte> bytes);

    void Closed(Handle handle);
}
