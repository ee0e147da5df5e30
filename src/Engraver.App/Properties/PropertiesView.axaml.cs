using Avalonia.Controls;

namespace Engraver.App.Properties;

/// <summary>The palette of what is selected.</summary>
public partial class PropertiesView : UserControl
{
    public PropertiesView() => InitializeComponent();
}
