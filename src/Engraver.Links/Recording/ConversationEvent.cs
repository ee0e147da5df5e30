namespace Engraver.Links.Recording;

/// <summary>An event on a link.</summary>
public enum ConversationEvent
{
    Opened,
    Said,
    Closed,
}
